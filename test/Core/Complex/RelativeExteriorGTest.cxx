/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/LocalOperations.h"
#include "Complex/RelativeExterior.h"
#include "TestComplexes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace tissue_test;

namespace
{
void
ExpectNear(const Point & found, const Point & expected)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(found[axis], expected[axis], 1e-12) << "axis " << axis;
  }
}

/** The corners of a regular octahedron, at distance 1, as cells 1 to 6 (+x, +y, +z, -x, -y, -z), and its centre. */
std::vector<Point>
Octahedron()
{
  return { NoPosition,       { { 1, 0, 0 } },  { { 0, 1, 0 } },  { { 0, 0, 1 } },
           { { -1, 0, 0 } }, { { 0, -1, 0 } }, { { 0, 0, -1 } }, { { 0, 0, 0 } } };
}

class RelativeExteriorOfOctahedron : public testing::Test
{
protected:
  std::vector<Point> m_Centers = Octahedron();
  AdjacencyComplex   m_Complex = DelaunayComplex(m_Centers);
  RelativeExterior   m_Exterior{ m_Complex, m_Centers };
};
} // namespace

TEST_F(RelativeExteriorOfOctahedron, NormalsPointOutwards)
{
  for (VertexId v = 1; v <= 6; ++v)
  {
    ExpectNear(m_Exterior.Normal(v), m_Centers[v]);
  }
}

TEST_F(RelativeExteriorOfOctahedron, AnInnerCellHasNoNormal)
{
  ExpectNear(m_Exterior.Normal(7), { { 0, 0, 0 } });
}

TEST_F(RelativeExteriorOfOctahedron, OfAnExteriorEdgeAtTheMeanDistanceOfItsRing)
{
  // The four other corners of the ring are at sqrt(2).
  ExpectNear(m_Exterior.OfExteriorEdge(2), { { 0, 1 + std::sqrt(2.0), 0 } });
}

TEST_F(RelativeExteriorOfOctahedron, OfAnEdgeAtItsLengthFromItsMiddle)
{
  // (0.5, 0.5, 0) and sqrt(2) along (1, 1, 0) / sqrt(2)
  ExpectNear(m_Exterior.OfEdge(1, 2), { { 1.5, 1.5, 0 } });
}

TEST_F(RelativeExteriorOfOctahedron, OfATriangleAtItsMeanEdgeLengthFromItsBarycentre)
{
  const double coordinate = 1.0 / 3.0 + std::sqrt(2.0) / std::sqrt(3.0);
  ExpectNear(m_Exterior.OfTriangle({ { 1, 2, 3 } }), { { coordinate, coordinate, coordinate } });
}

TEST(RelativeExterior, NormalsAreWeightedByArea)
{
  // At the corner (0, 0, 0): areas 1/2 towards -x, 1 towards -y and 1 towards -z.
  const std::vector<Point> centers{ NoPosition, { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  const AdjacencyComplex   complex = DelaunayComplex(centers);
  ExpectNear(RelativeExterior(complex, centers).Normal(1), { { -1.0 / 3.0, -2.0 / 3.0, -2.0 / 3.0 } });
}

TEST_F(RelativeExteriorOfOctahedron, NormalsFollowTheCurrentSurface)
{
  // With the tetrahedron (1, 2, 3, 7) taken from the tissue, the centre is on the surface: a pit towards (1, 1, 1).
  const auto      ring = m_Complex.GetRing(1, 2);
  LocalOperations operations(m_Complex, m_Centers, Legality::Combinatorial);
  for (const TetrahedronId id : ring.tetrahedra)
  {
    const VertexQuadruple t = m_Complex.GetTetrahedron(id).vertices;
    if (Canonical(t)[0] == ExteriorVertex && std::count(t.begin(), t.end(), 3) == 1)
    {
      m_Complex.Apply(
        operations.SwapTriangle(id, static_cast<int>(std::find(t.begin(), t.end(), ExteriorVertex) - t.begin()))
          .replacement);
      break;
    }
  }
  const double third = 1.0 / std::sqrt(3.0);
  ExpectNear(m_Exterior.Normal(7), { { third, third, third } });
}
