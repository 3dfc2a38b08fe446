/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Points/PointJunctions.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>

namespace
{
using namespace tissue;

std::string
ErrorOf(const std::vector<Point> & points, const std::vector<Label> & labels)
{
  try
  {
    MakePointJunctions(points, labels, 9);
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return "none";
}

/** Unit cubes of an L: two arms of 3 x 3 x 12, at a right angle; their middles, moved a little. */
std::vector<Point>
MakeAngle()
{
  std::mt19937       random(5);
  const auto         jitter = [&random] { return 0.2 * (static_cast<double>(random() % 1000) / 1000.0 - 0.5); };
  std::vector<Point> points;
  for (int x = 0; x < 12; ++x)
  {
    for (int y = 0; y < 12; ++y)
    {
      for (int z = 0; z < 3 && (x < 3 || y < 3); ++z)
      {
        points.push_back({ { x + jitter(), y + jitter(), z + jitter() } });
      }
    }
  }
  return points;
}
} // namespace

TEST(PointJunctions, AreCellsWithoutWalls)
{
  const JunctionSet set =
    MakePointJunctions({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } }, { -2, 3, 4, 70 }, 9);
  ASSERT_EQ(set.cells.size(), 5u);
  EXPECT_EQ(set.cells[0].label, 9);
  EXPECT_EQ(set.cells[4].label, 70);
  EXPECT_EQ(set.cells[4].center, (Point{ { 0, 0, 1 } }));
  EXPECT_TRUE(set.walls.empty());
}

TEST(PointJunctions, SayWhatTheyCannotBeMadeOf)
{
  const std::vector<Point> four{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  EXPECT_EQ(ErrorOf({ four.begin(), four.begin() + 3 }, { 1, 2, 3 }), "There are 3 points, at least 4 are needed");
  EXPECT_EQ(ErrorOf(four, { 1, 2, 3 }), "There are 4 points, but 3 labels");
  EXPECT_EQ(ErrorOf(four, { 1, 3, 3, 4 }), "Label 3 comes after 3, labels must ascend");
  EXPECT_EQ(ErrorOf(four, { 1, 2, 3, 9 }), "Label 9 of a point is the exterior's");
  std::vector<Point> wrong = four;
  wrong[2][1] = std::numeric_limits<double>::quiet_NaN();
  const std::string allowed = ", must be finite and at most 1e+30 in size";
  EXPECT_EQ(ErrorOf(wrong, { 1, 2, 3, 4 }), "The point of label 3 has the coordinate nan" + allowed);
  wrong[2][1] = -2e30;
  EXPECT_EQ(ErrorOf(wrong, { 1, 2, 3, 4 }), "The point of label 3 has the coordinate -2e+30" + allowed);
  for (Point & point : wrong = four)
  {
    point[0] = 5.0 + 1e-31 * point[0];
    point[1] = point[2] = 0.0;
  }
  EXPECT_EQ(ErrorOf(wrong, { 1, 2, 3, 4 }), "The points extend over 0, must be 1e-30 at least");
}

TEST(PointJunctions, ConcaveTissueStaysConcave)
{
  const std::vector<Point> points = MakeAngle();
  std::vector<Label>       labels(points.size());
  std::iota(labels.begin(), labels.end(), 1);
  const JunctionSet        set = MakePointJunctions(points, labels);
  ReconstructionParameters parameters = ReconstructionParameters::PaperPointsPreset();
  parameters.keepStages = true;
  const TissueReconstruction tissue = ReconstructTissue(set, parameters);
  EXPECT_TRUE(tissue.remarks.empty());
  ASSERT_EQ(tissue.stages.size(), 3u);
  EXPECT_EQ(tissue.stages.front().tuples.quadruples.size(), tissue.stages.front().statistics.numberOfTetrahedra);
  // l_max is 1.5 times a distance of eight neighbours, six at 1 and others at the root of 2, fewer at the surface.
  EXPECT_NEAR(tissue.maximumEdgeLength, 1.7, 0.2);

  const auto longest = [&](const ReconstructionStage & stage) {
    double length = 0.0;
    for (const auto & [u, v] : stage.tuples.pairs)
    {
      length = u == ExteriorVertex ? length : std::max(length, Distance(set.cells[u].center, set.cells[v].center));
    }
    return length;
  };
  EXPECT_GT(longest(tissue.stages.front()), 8.0);
  EXPECT_LT(longest(tissue.stages.back()), 3.5);
  const auto check = CheckCellSurfaces(tissue.walls, static_cast<VertexId>(set.cells.size()));
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  double volume = 0.0;
  for (std::size_t v = 1; v < set.cells.size(); ++v)
  {
    volume += check.cells[v].volume;
  }
  // The hull of the centres of the arms has 2 x 2 of 3 x 3; of what is above, the rims are cut off.
  EXPECT_NEAR(volume / static_cast<double>(points.size()), 0.77, 0.07);
}
