/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/CellCorners.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace tissue_test;

namespace
{
void
ExpectNear(const Point & found, const Point & expected, double tolerance = 1e-12)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found[axis], expected[axis], tolerance) << "axis " << axis;
  }
}

using Tetrahedron = std::array<Point, 4>;
using TrianglePoints = std::array<Point, 3>;
} // namespace

TEST(CellCorners, OfAnAcuteTriangleTheCircumcentre)
{
  const double height = std::sqrt(3.0);
  ExpectNear(ProjectedCircumcenter(TrianglePoints{ { { { -1, 0, 5 } }, { { 1, 0, 5 } }, { { 0, height, 5 } } } }),
             { { 0, height / 3.0, 5 } });
}

TEST(CellCorners, OfAnObtuseOrRightTriangleTheMiddleOfItsLongestEdge)
{
  ExpectNear(ProjectedCircumcenter(TrianglePoints{ { { { -2, 0, 0 } }, { { 2, 0, 0 } }, { { 1, 0.5, 0 } } } }),
             { { 0, 0, 0 } });
  ExpectNear(ProjectedCircumcenter(TrianglePoints{ { { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 2, 0 } } } }),
             { { 1, 1, 0 } });
  ExpectNear(ProjectedCircumcenter(TrianglePoints{ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 4, 0, 0 } } } }),
             { { 2, 0, 0 } });
}

TEST(CellCorners, OfARegularTetrahedronTheCircumcentre)
{
  const auto p = RegularTetrahedron();
  ExpectNear(ProjectedCircumcenter(Tetrahedron{ { p[1], p[2], p[3], p[4] } }), { { 0, 0, 0 } });
}

TEST(CellCorners, FirstProjectionToTheCircumcentreOfTheClosestTriangle)
{
  // A low apex over an equilateral triangle of circumradius 1: the circumcentre lies below the base.
  const double      half = std::sqrt(3.0) / 2.0;
  const Tetrahedron low{ { { { 1, 0, 0 } }, { { -0.5, half, 0 } }, { { -0.5, -half, 0 } }, { { 0, 0, 0.5 } } } };
  ExpectNear(ProjectedCircumcenter(low), { { 0, 0, 0 } });
}

TEST(CellCorners, SecondProjectionToTheMiddleOfTheClosestEdge)
{
  // Four points near an arc: the circumcentre is far below the base, whose angle at (0, 1, 0) is obtuse.
  const Tetrahedron arc{ { { { -3, 0, 0 } }, { { 3, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0.5, 0.2 } } } };
  ExpectNear(ProjectedCircumcenter(arc), { { 0, 0, 0 } });
}

TEST(CellCorners, OfAFlatTetrahedronTheBarycentre)
{
  const Tetrahedron flat{ { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 3, 3, 0 } } } };
  ExpectNear(ProjectedCircumcenter(flat), { { 1, 1, 0 } });
}

TEST(CellCorners, NeverOutsideOfTheTetrahedron)
{
  Random random(1);
  int    projected = 0;
  for (int repeat = 0; repeat < 2000; ++repeat)
  {
    const auto        centers = RandomCenters(4, static_cast<std::uint64_t>(repeat));
    const Tetrahedron t{ { centers[1], centers[2], centers[3], centers[4] } };
    const Point       g = ProjectedCircumcenter(t);
    const double      volume = Dot(t[1] - t[0], Cross(t[2] - t[0], t[3] - t[0]));
    for (int i = 0; i < 4; ++i)
    {
      Tetrahedron other = t;
      other[i] = g;
      const double part = Dot(other[1] - other[0], Cross(other[2] - other[0], other[3] - other[0]));
      // The barycentric coordinate, but for rounding
      ASSERT_GE(part / volume, -1e-9 / std::abs(volume));
    }
    projected += std::abs(Distance(g, t[0]) - Distance(g, t[1])) > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(projected, 100);
  EXPECT_LT(projected, 1900);
}

TEST(CellCorners, OfAComplexAreInTheOrderOfItsTetrahedra)
{
  const auto             centers = RegularTetrahedron();
  const AdjacencyComplex complex(5, FourSimplex());
  const auto corners = ComputeCorners(complex, JunctionsOf(complex, centers), CornerRule::ProjectedCircumcenter);
  const auto tetrahedra = complex.GetTetrahedra();
  ASSERT_EQ(corners.size(), tetrahedra.size());
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    const VertexQuadruple & t = tetrahedra[i];
    // Of the triangle of cells where there is the exterior: a third of the sum; of the tetrahedron the origin.
    const Point expected =
      t[0] == ExteriorVertex ? (1.0 / 3.0) * (centers[t[1]] + centers[t[2]] + centers[t[3]]) : Point{ { 0, 0, 0 } };
    ExpectNear(corners[i], expected);
  }
}

TEST(CellCorners, JunctionsOfTheImageAreTakenAndMissingOnesAveraged)
{
  const auto             centers = RegularTetrahedron();
  const AdjacencyComplex complex(5, FourSimplex());
  JunctionSet            junctions = JunctionsOf(complex, centers);
  for (std::size_t i = 0; i < junctions.junctions.size(); ++i)
  {
    junctions.junctions[i].position = { { 10.0 + static_cast<double>(i * i), 0, 1 } };
  }
  const auto all = ComputeCorners(complex, junctions, CornerRule::ImageJunction);
  const auto tetrahedra = complex.GetTetrahedra();
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    VertexQuadruple key = tetrahedra[i];
    std::sort(key.begin(), key.end());
    for (const Junction & junction : junctions.junctions)
    {
      if (junction.cells == key)
      {
        ExpectNear(all[i], junction.position);
      }
    }
  }
  // Without the junction of the four cells: the mean of the other four, 10 + (0 + 1 + 4 + 9) / 4.
  ASSERT_EQ(junctions.junctions.back().cells, (VertexQuadruple{ { 1, 2, 3, 4 } }));
  junctions.junctions.pop_back();
  ExpectNear(ComputeCorners(complex, junctions, CornerRule::ImageJunction).back(), { { 13.5, 0, 1 } });
}

TEST(CellCorners, MissingNeighborsAreAveragedTogether)
{
  const auto             centers = RegularTetrahedron();
  const AdjacencyComplex complex(5, FourSimplex());
  JunctionSet            junctions = JunctionsOf(complex, centers);
  junctions.junctions.erase(junctions.junctions.begin() + 3, junctions.junctions.end());
  for (std::size_t i = 0; i < 3; ++i)
  {
    junctions.junctions[i].position = { { 3.0 * static_cast<double>(i * i), 0, 0 } };
  }
  // Two corners p, q that are each other's neighbours: p = (0 + 3 + 12 + q) / 4 and likewise q, so both are 5; being at
  // one place, each is then moved by a twentieth of the way to the mean of its own cells.
  const auto corners = ComputeCorners(complex, junctions, CornerRule::ImageJunction);
  int        missing = 0;
  for (std::size_t i = 0; i < 5; ++i)
  {
    VertexQuadruple key = complex.GetTetrahedra()[i];
    std::sort(key.begin(), key.end());
    if (key == VertexQuadruple{ { 0, 2, 3, 4 } } || key == VertexQuadruple{ { 1, 2, 3, 4 } })
    {
      const Point mean =
        key[0] == ExteriorVertex ? (1.0 / 3.0) * (centers[2] + centers[3] + centers[4]) : Point{ { 0, 0, 0 } };
      ExpectNear(corners[i], 0.95 * Point{ { 5, 0, 0 } } + 0.05 * mean, 1e-6);
      ++missing;
    }
  }
  EXPECT_EQ(missing, 2);
}
