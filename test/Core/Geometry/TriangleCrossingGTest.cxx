/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/ExactPredicates.h"
#include "Geometry/TriangleCrossing.h"
#include "TissueTessellationCore/Common/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using tissue::Point;
using tissue::Triangle;

/** Whether the two cross, the same for every order of the triangles and of their points. */
bool
Cross(const std::vector<Point> & points, Triangle a, Triangle b)
{
  const bool result = tissue::TrianglesCross(points, a, b);
  for (int turn = 0; turn < 6; ++turn)
  {
    std::rotate(a.begin(), a.begin() + 1, a.end());
    if (turn == 3)
    {
      std::swap(b[0], b[1]);
    }
    std::rotate(b.begin(), b.begin() + (turn + 1) % 2, b.end());
    EXPECT_EQ(tissue::TrianglesCross(points, a, b), result) << "turn " << turn;
    EXPECT_EQ(tissue::TrianglesCross(points, b, a), result) << "turn " << turn;
  }
  return result;
}

/** Likewise, of triangles that share no index. */
bool
CrossApart(const std::array<Point, 3> & a, const std::array<Point, 3> & b)
{
  return Cross({ a[0], a[1], a[2], b[0], b[1], b[2] }, { { 0, 1, 2 } }, { { 3, 4, 5 } });
}

constexpr double           above = 1.0 + 1e-15;
const std::array<Point, 3> flat{ { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } } } };
} // namespace

TEST(TriangleCrossing, InOnePlaneWhereTheyOverlapOrTouch)
{
  EXPECT_TRUE(CrossApart(flat, { { { { 1, 1, 0 } }, { { 5, 1, 0 } }, { { 1, 5, 0 } } } })) << "overlap";
  EXPECT_TRUE(CrossApart(flat, { { { { 1, 1, 0 } }, { { 2, 1, 0 } }, { { 1, 2, 0 } } } })) << "one within the other";
  EXPECT_TRUE(CrossApart(flat, { { { { 4, 0, 0 } }, { { 8, 0, 0 } }, { { 8, 4, 0 } } } })) << "touch at corners";
  EXPECT_TRUE(CrossApart(flat, { { { { 2, 2, 0 } }, { { 4, 4, 0 } }, { { 4, 5, 0 } } } })) << "a corner on an edge";
  EXPECT_TRUE(CrossApart(flat, { { { { 4, 0, 0 } }, { { 0, 4, 0 } }, { { 4, 4, 0 } } } })) << "touch along an edge";
  EXPECT_FALSE(CrossApart(flat, { { { { 2, 2 * above, 0 } }, { { 4, 4, 0 } }, { { 4, 5, 0 } } } })) << "a hair apart";
  EXPECT_FALSE(CrossApart(flat, { { { { 1, 1, 1 } }, { { 5, 1, 1 } }, { { 1, 5, 1 } } } })) << "parallel";
}

TEST(TriangleCrossing, InAPlaneThatRoundingWouldHide)
{
  // On x + y + z = 1 exactly.
  const std::array<Point, 3> tilted{ { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  EXPECT_TRUE(CrossApart(tilted, { { { { 0.5, 0.25, 0.25 } }, { { 3, -1, -1 } }, { { 3, -1.5, -0.5 } } } }));
  EXPECT_FALSE(CrossApart(tilted, { { { { 1.25, -0.125, -0.125 } }, { { 3, -1, -1 } }, { { 3, -1.5, -0.5 } } } }));
  EXPECT_FALSE(CrossApart(tilted, { { { { 0.5, 0.25, 0.25 + 1e-16 * 4 } }, { { 3, -1, 0 } }, { { 3, -1.5, 0.5 } } } }));
}

TEST(TriangleCrossing, InSpaceWhereAPointIsCommon)
{
  EXPECT_TRUE(CrossApart(flat, { { { { 1, 1, -1 } }, { { 1, 1, 1 } }, { { 2, 1, 1 } } } })) << "through";
  EXPECT_TRUE(CrossApart(flat, { { { { 1, 1, 0 } }, { { 1, 1, 1 } }, { { 2, 1, 1 } } } })) << "a corner within";
  EXPECT_TRUE(CrossApart(flat, { { { { 0, 0, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } } } })) << "equal corners";
  EXPECT_TRUE(CrossApart(flat, { { { { 2, 0, 0 } }, { { 2, -1, 1 } }, { { 2, -1, -1 } } } })) << "a corner on an edge";
  EXPECT_TRUE(CrossApart(flat, { { { { 2, -1, -1 } }, { { 2, 1, 1 } }, { { 2, -1, 1 } } } })) << "edges";
  EXPECT_FALSE(CrossApart(flat, { { { { 1, 1, 1e-300 } }, { { 1, 1, 1 } }, { { 2, 1, 1 } } } })) << "a hair above";
  EXPECT_FALSE(CrossApart(flat, { { { { 3, 3, -1 } }, { { 3, 3, 1 } }, { { 4, 3, 1 } } } })) << "beside";
}

TEST(TriangleCrossing, WithASharedPointWhereMoreIsCommon)
{
  const std::vector<Point> points{ { { 0, 0, 0 } }, { { 4, 0, 0 } },   { { 0, 4, 0 } },  { { 1, 1, -1 } },
                                   { { 1, 1, 1 } }, { { -4, 0, 0 } },  { { 0, -4, 0 } }, { { 2, 2, 0 } },
                                   { { 2, 1, 0 } }, { { 1, -4, 0 } },  { { 8, 0, 0 } },  { { 0, -1, 5 } },
                                   { { 2, 0, 0 } }, { { -4, -1, 0 } }, { { 5, 5, 1 } },  { { 5, 4, 1 } } };
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 3, 4 } })) << "the opposite edge goes through";
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 5, 6 } })) << "opposite in one plane";
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 14, 15 } })) << "above";
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 7, 8 } })) << "overlap in one plane";
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 10, 9 } })) << "edges on one another";
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 12, 11 } })) << "an edge on a part of the other's";
}

TEST(TriangleCrossing, WithASharedEdgeWhereOneIsFoldedOntoTheOther)
{
  const std::vector<Point> points{ { { 0, 0, 0 } }, { { 4, 0, 0 } },      { { 0, 4, 0 } },
                                   { { 3, 1, 0 } }, { { 1, -4, 0 } },     { { 1, 4, 3 } },
                                   { { 9, 5, 0 } }, { { 3, 1, 1e-300 } }, { { -3, 1e-200, 0 } } };
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 3 } }));
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 6 } })) << "neither within the other";
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 8 } })) << "a sliver";
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 4 } })) << "flat";
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 5 } })) << "at an angle";
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 7 } })) << "all but folded";
}

TEST(TriangleCrossing, OfTheSameTriangle)
{
  std::vector<Point> points(flat.begin(), flat.end());
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 2 } }));
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 2, 1 } }));
  EXPECT_TRUE(CrossApart(flat, flat)) << "by its places";
}

TEST(TriangleCrossing, FilterKnowsWhatExactArithmeticSays)
{
  // On a small grid most positions are special.
  tissue::Random random(1);
  const auto     makeTriangle = [&random] {
    std::array<Point, 3> t;
    for (Point & p : t)
    {
      for (double & x : p)
      {
        x = std::floor(4.0 * random.Uniform());
      }
    }
    return t;
  };
  int numberOfMeetings = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const auto a = makeTriangle();
    const auto b = makeTriangle();
    const bool meet = tissue::TrianglesMeet(a, b);
    numberOfMeetings += meet ? 1 : 0;
    ASSERT_EQ(tissue::TrianglesCross({ a[0], a[1], a[2], b[0], b[1], b[2] }, { { 0, 1, 2 } }, { { 3, 4, 5 } }), meet);
  }
  EXPECT_GT(numberOfMeetings, 1000);
  EXPECT_LT(numberOfMeetings, 19000);
}

TEST(TriangleCrossing, OfASegmentThatIsATriangleByItsPointsAlone)
{
  const std::array<Point, 3> through{ { { { 1, 1, -1 } }, { { 1, 1, 0.5 } }, { { 1, 1, 2 } } } };
  const std::array<Point, 3> beside{ { { { 3, 3, -1 } }, { { 3, 3, 0.5 } }, { { 3, 3, 2 } } } };
  const std::array<Point, 3> point{ { { { 1, 1, 0 } }, { { 1, 1, 0 } }, { { 1, 1, 0 } } } };
  EXPECT_TRUE(CrossApart(flat, through));
  EXPECT_FALSE(CrossApart(flat, beside));
  EXPECT_FALSE(CrossApart(through, beside));
  EXPECT_TRUE(CrossApart(flat, point));
  EXPECT_TRUE(CrossApart(through, point));
  // The shared point between the two others.
  const std::vector<Point> points{ { { 0, 0, 0 } },  { { 4, 0, 0 } },   { { 0, 4, 0 } }, { { 0, 0, 1 } },
                                   { { 0, 0, -1 } }, { { -1, -1, 0 } }, { { 1, 1, 0 } } };
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 3, 4 } }));
  EXPECT_TRUE(Cross(points, { { 0, 1, 2 } }, { { 0, 5, 6 } }));
  // A point twice.
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 0, 3 } }));
  EXPECT_FALSE(Cross(points, { { 0, 1, 2 } }, { { 0, 1, 1 } }));
}

TEST(TriangleCrossing, SharedPointsAreNoCrossing)
{
  const std::vector<Point> points{ { { 0, 0, 0 } },  { { 2, 0, 0 } },      { { 0, 2, 0 } },
                                   { { 1, 1, 1 } },  { { 1, 1, -1 } },     { { 2, 2, 0 } },
                                   { { -1, 0, 0 } }, { { 0.5, 0.5, -1 } }, { { 0.5, 0.5, 1 } } };
  EXPECT_FALSE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 2, 3 } })) << "an edge";
  EXPECT_FALSE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 6, 3 } })) << "a point";
  EXPECT_FALSE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 1, 5, 3 } })) << "a point";
  EXPECT_TRUE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 7, 8 } }))
    << "a point, and the edge opposite to it";
  EXPECT_TRUE(tissue::TrianglesCross(points, { { 0, 7, 8 } }, { { 0, 1, 2 } }));
}

TEST(TriangleCrossing, TrianglesInOnePlaneCrossWhereTheyOverlap)
{
  const std::vector<Point> points{ { { 0, 0, 0 } },  { { 2, 0, 0 } }, { { 0, 2, 0 } },    { { -2, 0, 0 } },
                                   { { 0, -2, 0 } }, { { 2, 2, 0 } }, { { 0.5, 0.5, 0 } } };
  EXPECT_FALSE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 3, 4 } })) << "opposite triangles of a flat star";
  EXPECT_TRUE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 6, 5, 3 } }));
  EXPECT_TRUE(tissue::TrianglesCross(points, { { 0, 1, 2 } }, { { 0, 5, 3 } })) << "with a shared point";
}
