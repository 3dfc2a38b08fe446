/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TestComplexes_h
#define TestComplexes_h

#include "Complex/AdjacencyComplex.h"
#include "Complex/ComplexValidity.h"
#include "Complex/DelaunayTetrahedralization.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

/** Complexes for the tests of the core. Vertex 0 is the exterior; its position is NaN, so that no use of it can hide.
 */
namespace tissue_test
{
using namespace tissue;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const Point      NoPosition{ { NaN, NaN, NaN } };

/** A positive tetrahedron to the exterior on a surface triangle that is counterclockwise seen from outside. */
inline VertexQuadruple
ToExterior(VertexId a, VertexId b, VertexId c)
{
  return { { ExteriorVertex, a, c, b } };
}

/** One regular tetrahedron of edge 2 sqrt(2) around the origin, cells 1 to 4. */
inline std::vector<Point>
RegularTetrahedron()
{
  return { NoPosition, { { 1, 1, 1 } }, { { -1, 1, -1 } }, { { 1, -1, -1 } }, { { -1, -1, 1 } } };
}

/** The boundary of the 4-simplex: one tetrahedron of cells and the exterior on its four sides. */
inline std::vector<VertexQuadruple>
FourSimplex()
{
  const VertexQuadruple        cells{ { 1, 2, 3, 4 } };
  std::vector<VertexQuadruple> tetrahedra{ cells };
  for (int i = 0; i < 4; ++i)
  {
    const VertexTriple t = TriangleOpposite(cells, i);
    tetrahedra.push_back(ToExterior(t[0], t[1], t[2]));
  }
  return tetrahedra;
}

/** n tetrahedra around the edge (1, 2); its ring is 3, ..., n + 2, counterclockwise seen from 2. */
inline std::vector<VertexQuadruple>
Bipyramid(int n)
{
  std::vector<VertexQuadruple> tetrahedra;
  for (int i = 0; i < n; ++i)
  {
    const VertexId p = 3 + i;
    const VertexId q = 3 + (i + 1) % n;
    tetrahedra.push_back({ { 1, 2, p, q } });
    tetrahedra.push_back(ToExterior(2, p, q));
    tetrahedra.push_back(ToExterior(1, q, p));
  }
  return tetrahedra;
}

/** Positions for Bipyramid(): 1 and 2 at (0, 0, -1) and (0, 0, 1), then the ring. */
inline std::vector<Point>
BipyramidCenters(const std::vector<Point> & ring)
{
  std::vector<Point> centers{ NoPosition, { { 0, 0, -1 } }, { { 0, 0, 1 } } };
  centers.insert(centers.end(), ring.begin(), ring.end());
  return centers;
}

/** The given quadruples turned so that all are oriented as the first one. They must be connected by triangles. */
inline std::vector<VertexQuadruple>
Oriented(std::vector<VertexQuadruple> tetrahedra)
{
  const auto cyclic = [](VertexTriple t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::map<VertexTriple, int> seen; // triangles of the oriented ones
  const auto                  add = [&](const VertexQuadruple & t) {
    for (int i = 0; i < 4; ++i)
    {
      ++seen[cyclic(TriangleOpposite(t, i))];
    }
  };
  add(tetrahedra[0]);
  for (std::size_t done = 1; done < tetrahedra.size(); ++done)
  {
    for (std::size_t k = done; k < tetrahedra.size(); ++k)
    {
      bool same = false;
      bool opposite = false;
      for (int i = 0; i < 4; ++i)
      {
        VertexTriple t = cyclic(TriangleOpposite(tetrahedra[k], i));
        same = same || seen.count(t) > 0;
        std::swap(t[1], t[2]);
        opposite = opposite || seen.count(t) > 0;
      }
      if (same || opposite)
      {
        std::swap(tetrahedra[done], tetrahedra[k]);
        if (same)
        {
          std::swap(tetrahedra[done][0], tetrahedra[done][1]);
        }
        add(tetrahedra[done]);
        break;
      }
    }
  }
  return tetrahedra;
}

/** The boundary of the cyclic 4-polytope: n vertices, every two adjacent (D. Gale, Neighborly and cyclic polytopes). */
inline std::vector<VertexQuadruple>
CyclicPolytope(int n)
{
  std::vector<VertexQuadruple> tetrahedra;
  for (int i = 0; i < n; ++i)
  {
    for (int j = i + 2; j < n && (j + 1) % n != i; ++j)
    {
      tetrahedra.push_back({ { i, i + 1, j, (j + 1) % n } });
    }
  }
  return Oriented(tetrahedra);
}

/** The boundary of the 4-dimensional cross-polytope; v and the vertex opposite to it, v + 4, are not adjacent. */
inline std::vector<VertexQuadruple>
CrossPolytope()
{
  std::vector<VertexQuadruple> tetrahedra;
  for (int signs = 0; signs < 16; ++signs)
  {
    VertexQuadruple t;
    for (int axis = 0; axis < 4; ++axis)
    {
      t[axis] = axis + ((signs >> axis) % 2) * 4;
    }
    tetrahedra.push_back(t);
  }
  return Oriented(tetrahedra);
}

/** Cells uniform in a cube of the given side. */
inline std::vector<Point>
RandomCenters(int numberOfCells, std::uint64_t seed, double side = 1.0)
{
  Random             random(seed);
  std::vector<Point> centers{ NoPosition };
  for (int i = 0; i < numberOfCells; ++i)
  {
    const double x = side * random.Uniform();
    const double y = side * random.Uniform();
    centers.push_back({ { x, y, side * random.Uniform() } });
  }
  return centers;
}

/** The point at equal distance from four points. */
inline Point
Circumcenter(const Point & p, const Point & q, const Point & r, const Point & s)
{
  const Point a = q - p;
  const Point b = r - p;
  const Point c = s - p;
  const Point sum = Dot(a, a) * Cross(b, c) + Dot(b, b) * Cross(c, a) + Dot(c, c) * Cross(a, b);
  return p + (0.5 / Dot(a, Cross(b, c))) * sum;
}

inline AdjacencyComplex
DelaunayComplex(const std::vector<Point> & centers)
{
  return AdjacencyComplex(static_cast<VertexId>(centers.size()), DelaunayTetrahedralization(centers));
}

/** What an image would give from which the complex reads exactly: its edges as walls, its tetrahedra as junctions. */
inline JunctionSet
JunctionsOf(const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  JunctionSet junctions;
  for (std::size_t v = 0; v < centers.size(); ++v)
  {
    Cell cell;
    cell.label = static_cast<Label>(v);
    cell.center = centers[v];
    junctions.cells.push_back(cell);
  }
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    Wall wall;
    wall.cells = edge.vertices;
    junctions.walls.push_back(wall);
  }
  for (VertexQuadruple t : complex.GetTetrahedra())
  {
    std::sort(t.begin(), t.end());
    Junction junction;
    junction.cells = t;
    junctions.junctions.push_back(junction);
  }
  std::sort(junctions.junctions.begin(), junctions.junctions.end(), [](const Junction & a, const Junction & b) {
    return a.cells < b.cells;
  });
  return junctions;
}

} // namespace tissue_test

#endif
