/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** The most cells that may meet at a point, the exterior counted: the dual of a tetrahedron has four. */
constexpr std::size_t maximalCellsAtPoint = 4;
/** A triangle whose area over its longest edge squared is less is taken for degenerate: rounding leaves as much of flat
 * ones. */
constexpr double degenerateAreaRatio = 1e-12;

/** Item numbers 0, 1, ... grouped by a key: 32 bits hold those of half-edges, see RequireConsistentIndices. */
using Groups = CompressedRows<std::uint32_t, std::uint32_t>;

/** Groups the numbers below `numberOfItems` by keyOf(number). */
template <typename TKeyOf>
void
Group(Groups & groups, std::size_t numberOfItems, std::size_t numberOfKeys, const TKeyOf & keyOf)
{
  groups.Assign(numberOfKeys, [&](const auto & add) {
    for (std::size_t i = 0; i < numberOfItems; ++i)
    {
      add(keyOf(i), static_cast<std::uint32_t>(i));
    }
  });
}

bool
IsDegenerate(const WallMesh & mesh, const Triangle & triangle)
{
  const Point & a = mesh.points[triangle[0]];
  const Point & b = mesh.points[triangle[1]];
  const Point & c = mesh.points[triangle[2]];
  const auto    squaredLength = [](const Point & p, const Point & q) {
    const Point edge = p - q;
    return Dot(edge, edge);
  };
  const double longest = std::max({ squaredLength(a, b), squaredLength(b, c), squaredLength(c, a) });
  // Negated, so that a point that is not a number is found as well.
  return !(TriangleArea(a, b, c) > degenerateAreaRatio * longest);
}

/** Measures the cells of a mesh one after the other; its buffers are kept from cell to cell. */
class CellSurfaceMeter
{
public:
  CellSurfaceMeter(const WallMesh & mesh, VertexId numberOfVertices)
    : m_Mesh(mesh)
    , m_CellOfPoint(mesh.points.size(), ExteriorVertex)
    , m_LocalIndex(mesh.points.size())
    , m_CellOfWall(mesh.walls.size(), ExteriorVertex)
  {
    // Item 2 t + s is the side of triangle t that is turned to the wall's cell s.
    Group(m_SidesOfCell, 2 * mesh.triangles.size(), numberOfVertices, [&mesh](std::size_t side) {
      return mesh.walls[mesh.wallOfTriangle[side / 2]].cells[side % 2];
    });
  }

  CellSurface
  Measure(VertexId cell)
  {
    CellSurface surface;
    this->GatherTriangles(cell, surface);
    const std::int64_t numberOfEdges = this->ClassifyEdges(surface);
    surface.eulerCharacteristic =
      static_cast<std::int32_t>(m_NumberOfPoints - numberOfEdges + surface.numberOfTriangles);
    return surface;
  }

private:
  using LocalTriangle = std::array<std::uint32_t, 3>;

  /** Triangles of the cell, turned outwards, by local point numbers; their sums. */
  void
  GatherTriangles(VertexId cell, CellSurface & surface)
  {
    m_NumberOfPoints = 0;
    m_Triangles.clear();
    double sixfoldVolume = 0.0;
    for (const std::uint32_t side : m_SidesOfCell[cell])
    {
      Triangle triangle = m_Mesh.triangles[side / 2];
      if (side % 2 == 1)
      {
        std::swap(triangle[1], triangle[2]);
      }
      const WallId wall = m_Mesh.wallOfTriangle[side / 2];
      surface.numberOfWalls += m_CellOfWall[wall] == cell ? 0 : 1;
      m_CellOfWall[wall] = cell;
      m_Triangles.push_back({ { this->Localize(triangle[0], cell),
                                this->Localize(triangle[1], cell),
                                this->Localize(triangle[2], cell) } });

      // Volumes are taken from a point of the cell: from the origin they would be differences of large numbers.
      const Point & origin = m_Mesh.points[m_Origin];
      const Point & a = m_Mesh.points[triangle[0]];
      const Point & b = m_Mesh.points[triangle[1]];
      const Point & c = m_Mesh.points[triangle[2]];
      surface.area += TriangleArea(a, b, c);
      sixfoldVolume += Dot(a - origin, Cross(b - origin, c - origin));
    }
    surface.volume = sixfoldVolume / 6.0;
    surface.numberOfTriangles = static_cast<std::int32_t>(m_Triangles.size());
  }

  std::uint32_t
  Localize(PointId point, VertexId cell)
  {
    if (m_CellOfPoint[point] != cell)
    {
      m_Origin = m_NumberOfPoints == 0 ? point : m_Origin;
      m_CellOfPoint[point] = cell;
      m_LocalIndex[point] = m_NumberOfPoints++;
    }
    return m_LocalIndex[point];
  }

  std::uint32_t
  FromPoint(std::uint32_t halfEdge) const
  {
    return m_Triangles[halfEdge / 3][halfEdge % 3];
  }

  std::uint32_t
  ToPoint(std::uint32_t halfEdge) const
  {
    return m_Triangles[halfEdge / 3][(halfEdge + 1) % 3];
  }

  /** Counts the faults of the edges and the components; returns the number of edges. */
  std::int64_t
  ClassifyEdges(CellSurface & surface)
  {
    Group(m_HalfEdgesOfPoint, 3 * m_Triangles.size(), m_NumberOfPoints, [this](std::size_t halfEdge) {
      return std::min(this->FromPoint(halfEdge), this->ToPoint(halfEdge));
    });
    DisjointSets components(m_Triangles.size());
    const auto   upperPoint = [this](std::uint32_t halfEdge) {
      return std::max(this->FromPoint(halfEdge), this->ToPoint(halfEdge));
    };
    std::int64_t numberOfEdges = 0;
    for (std::uint32_t point = 0; point < m_NumberOfPoints; ++point)
    {
      const auto end = m_HalfEdgesOfPoint[point].end();
      auto       first = m_HalfEdgesOfPoint[point].begin();
      std::sort(first, end, [&](std::uint32_t a, std::uint32_t b) { return upperPoint(a) < upperPoint(b); });
      while (first != end)
      {
        auto last = first + 1;
        for (; last != end && upperPoint(*last) == upperPoint(*first); ++last)
        {
          components.Unite(*first / 3, *last / 3);
        }
        surface.numberOfOpenEdges += last - first == 1 ? 1 : 0;
        surface.numberOfCrowdedEdges += last - first > 2 ? 1 : 0;
        const auto runsUpwards = [&](std::uint32_t halfEdge) { return this->FromPoint(halfEdge) == point; };
        const bool isBalanced = 2 * std::count_if(first, last, runsUpwards) == last - first;
        surface.numberOfMisorientedEdges += last - first > 1 && !isBalanced ? 1 : 0;
        ++numberOfEdges;
        first = last;
      }
    }
    for (std::int32_t t = 0; t < surface.numberOfTriangles; ++t)
    {
      surface.numberOfComponents += components.Find(t) == t ? 1 : 0;
    }
    return numberOfEdges;
  }

  const WallMesh &           m_Mesh;
  Groups                     m_SidesOfCell;
  std::vector<VertexId>      m_CellOfPoint;
  std::vector<std::uint32_t> m_LocalIndex;
  std::vector<VertexId>      m_CellOfWall;
  Groups                     m_HalfEdgesOfPoint;
  std::vector<LocalTriangle> m_Triangles;
  std::uint32_t              m_NumberOfPoints = 0;
  PointId                    m_Origin = 0;
};

/** How many cells meet at each point, by the triangles. */
void
CheckPoints(const WallMesh & mesh, CellSurfaceCheck & check)
{
  Groups corners;
  Group(corners, 3 * mesh.triangles.size(), mesh.points.size(), [&mesh](std::size_t corner) {
    return mesh.triangles[corner / 3][corner % 3];
  });
  std::vector<VertexId> cells;
  for (std::size_t point = 0; point < mesh.points.size(); ++point)
  {
    cells.clear();
    for (const std::uint32_t corner : corners[point])
    {
      for (const VertexId cell : mesh.walls[mesh.wallOfTriangle[corner / 3]].cells)
      {
        if (std::find(cells.begin(), cells.end(), cell) == cells.end())
        {
          cells.push_back(cell);
        }
      }
    }
    if (cells.size() > maximalCellsAtPoint)
    {
      check.crowdedPoints.push_back(static_cast<PointId>(point));
    }
    const bool isMiscounted = !mesh.numberOfCells.empty() && mesh.numberOfCells[point] != cells.size();
    check.numberOfMiscountedPoints += isMiscounted ? 1 : 0;
    check.numberOfUnusedPoints += cells.empty() ? 1 : 0;
  }
}
} // namespace

CellSurfaceCheck
CheckCellSurfaces(const WallMesh & mesh, VertexId numberOfVertices)
{
  RequireConsistentIndices(mesh, numberOfVertices);
  CellSurfaceCheck check;
  check.cells.resize(numberOfVertices);
  CellSurfaceMeter meter(mesh, numberOfVertices);
  for (VertexId cell = ExteriorVertex + 1; cell < numberOfVertices; ++cell)
  {
    check.cells[cell] = meter.Measure(cell);
    if (check.cells[cell].numberOfTriangles == 0)
    {
      check.cellsWithoutTriangles.push_back(cell);
    }
    else if (!check.cells[cell].HasOnlySpheres())
    {
      check.cellsThatAreNoSphere.push_back(cell);
    }
  }
  CheckPoints(mesh, check);
  check.angles = MeasureWallAngles(mesh, numberOfVertices);
  check.numberOfDegenerateTriangles = std::count_if(
    mesh.triangles.begin(), mesh.triangles.end(), [&mesh](const auto & t) { return IsDegenerate(mesh, t); });
  return check;
}
} // namespace tissue
