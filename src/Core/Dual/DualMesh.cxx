/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/DualMesh.h"

#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>

namespace tissue
{
namespace
{
/** The index of the line of each triangle, by tetrahedron and opposite vertex; lines get their ends and middles. */
std::vector<std::array<std::int32_t, 4>>
NumberLines(const GeneralComplex & complex, const LinePathOf & pathOf, std::vector<DualMesh::Line> & lines)
{
  std::vector<std::array<std::int32_t, 4>> lineOf(complex.NumberOfTetrahedra());
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Side side{ id, i };
      const Side mate = complex.GetMate(side);
      if (id < mate.tetrahedron)
      {
        lineOf[id][i] = static_cast<std::int32_t>(lines.size());
        lineOf[mate.tetrahedron][mate.opposite] = lineOf[id][i];
        const LinePath path = pathOf(side);
        lines.push_back({ { { id, mate.tetrahedron } }, {}, path.middle, path.isBent });
      }
    }
  }
  return lineOf;
}

/** Turns the wall so that its smallest corner comes first, of several the one with the smallest line: equal complexes
 * then give equal walls whatever their history. */
void
TurnToSmallestCorner(DualMesh::Wall & wall)
{
  std::size_t first = 0;
  for (std::size_t i = 1; i < wall.corners.size(); ++i)
  {
    first = std::tie(wall.corners[i], wall.lines[i]) < std::tie(wall.corners[first], wall.lines[first]) ? i : first;
  }
  const auto by = static_cast<std::ptrdiff_t>(first);
  std::rotate(wall.corners.begin(), wall.corners.begin() + by, wall.corners.end());
  std::rotate(wall.lines.begin(), wall.lines.begin() + by, wall.lines.end());
}

/** The complex with its tetrahedra in the order of GetTetrahedra(). */
GeneralComplex
AsGeneral(const AdjacencyComplex & complex)
{
  const std::vector<std::int32_t> ranks = complex.GetTetrahedronRanks();
  GeneralComplex                  general(complex.NumberOfVertices());
  for (const VertexQuadruple & tetrahedron : complex.GetTetrahedra())
  {
    general.Add(tetrahedron);
  }
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; complex.IsAlive(id) && i < 4; ++i)
    {
      const AdjacencyComplex::Tetrahedron & t = complex.GetTetrahedron(id);
      const TetrahedronId                   neighbor = t.neighbors[i];
      if (id < neighbor)
      {
        const VertexId across = complex.GetTetrahedron(neighbor).vertices[complex.MirrorIndex(id, i)];
        general.Glue({ ranks[id], LocalIndex(general.GetTetrahedron(ranks[id]).vertices, t.vertices[i]) },
                     { ranks[neighbor], LocalIndex(general.GetTetrahedron(ranks[neighbor]).vertices, across) });
      }
    }
  }
  return general;
}

/** The points on doubled and bent lines; appended to the mesh. */
std::map<std::int32_t, PointId>
AddMiddles(const DualMesh & dual, WallMesh & mesh)
{
  std::map<std::array<PointId, 2>, int> counts;
  for (const DualMesh::Line & line : dual.lines)
  {
    ++counts[line.ends];
  }
  std::map<std::int32_t, PointId> middles;
  for (std::size_t i = 0; i < dual.lines.size(); ++i)
  {
    if (counts[dual.lines[i].ends] > 1 || dual.lines[i].isBent)
    {
      middles[static_cast<std::int32_t>(i)] = static_cast<PointId>(mesh.points.size());
      mesh.points.push_back(dual.lines[i].middle);
      mesh.numberOfCells.push_back(CellsOnLine);
    }
  }
  return middles;
}
} // namespace

DualMesh
Dualize(const GeneralComplex & complex, std::vector<Point> corners, const LinePathOf & pathOf)
{
  if (corners.size() != complex.NumberOfTetrahedra() ||
      complex.NumberOfTetrahedra() != static_cast<std::size_t>(complex.TetrahedronIdBound()))
  {
    throw std::invalid_argument("Dualize: " + std::to_string(corners.size()) + " corners for " +
                                std::to_string(complex.NumberOfTetrahedra()) + " tetrahedra");
  }
  DualMesh dual;
  dual.corners = std::move(corners);
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    dual.cellsOfCorner.push_back(complex.GetTetrahedron(id).vertices);
  }
  const auto lineOf = NumberLines(complex, pathOf, dual.lines);
  for (const GeneralComplex::Edge & edge : complex.FindEdges())
  {
    const bool      isTurned = edge.vertices[0] == ExteriorVertex;
    const LocalEdge local{ edge.local.tetrahedron,
                           isTurned ? edge.local.to : edge.local.from,
                           isTurned ? edge.local.from : edge.local.to };
    DualMesh::Wall  wall;
    wall.cells = { { edge.vertices[isTurned ? 1 : 0], edge.vertices[isTurned ? 0 : 1] } };
    // The ring of (u, v) is counterclockwise seen from v.
    for (const RingStep & step : complex.GetRing(local))
    {
      const std::int32_t line = lineOf[step.tetrahedron][step.here];
      const VertexId     third = complex.GetTetrahedron(step.tetrahedron).vertices[step.next];
      wall.corners.push_back(step.tetrahedron);
      wall.lines.push_back(line);
      // Counterclockwise seen from where the ring goes to, which may be the line's first end.
      dual.lines[line].cells = dual.lines[line].ends[0] == step.tetrahedron
                                 ? VertexTriple{ { wall.cells[0], wall.cells[1], third } }
                                 : VertexTriple{ { wall.cells[1], wall.cells[0], third } };
    }
    TurnToSmallestCorner(wall);
    dual.walls.push_back(std::move(wall));
  }
  std::sort(dual.walls.begin(), dual.walls.end(), [](const DualMesh::Wall & a, const DualMesh::Wall & b) {
    const auto [a0, a1] = std::minmax(a.cells[0], a.cells[1]);
    const auto [b0, b1] = std::minmax(b.cells[0], b.cells[1]);
    return std::tie(a0, a1, a.corners, a.lines) < std::tie(b0, b1, b.corners, b.lines);
  });
  return dual;
}

DualMesh
Dualize(const AdjacencyComplex & complex, std::vector<Point> corners)
{
  const std::vector<Point> positions = corners;
  const GeneralComplex     general = AsGeneral(complex);
  return Dualize(general, std::move(corners), [&](const Side & side) {
    const Point & to = positions.at(general.GetMate(side).tetrahedron);
    return LinePath{ 0.5 * (positions.at(side.tetrahedron) + to), false };
  });
}

void
TurnOver(DualMesh::Wall & wall)
{
  std::swap(wall.cells[0], wall.cells[1]);
  std::reverse(wall.corners.begin(), wall.corners.end());
  std::reverse(wall.lines.begin(), wall.lines.end());
  // A line is listed at the corner before it.
  std::rotate(wall.lines.begin(), wall.lines.begin() + 1, wall.lines.end());
}

WallMesh
TriangulateAsStars(const DualMesh & dual)
{
  WallMesh mesh;
  mesh.points = dual.corners;
  mesh.numberOfCells.assign(dual.corners.size(), CellsAtCorner);
  const std::map<std::int32_t, PointId> middles = AddMiddles(dual, mesh);
  for (const DualMesh::Wall & wall : dual.walls)
  {
    const auto           wallId = static_cast<WallId>(mesh.walls.size());
    const auto           center = static_cast<PointId>(mesh.points.size());
    std::vector<PointId> outline;
    for (std::size_t i = 0; i < wall.corners.size(); ++i)
    {
      outline.push_back(wall.corners[i]);
      const auto middle = middles.find(wall.lines[i]);
      if (middle != middles.end())
      {
        outline.push_back(middle->second);
      }
    }
    Point sum{ { 0.0, 0.0, 0.0 } };
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      sum = sum + mesh.points[outline[i]];
      mesh.triangles.push_back({ { center, outline[i], outline[(i + 1) % outline.size()] } });
      mesh.wallOfTriangle.push_back(wallId);
    }
    mesh.points.push_back((1.0 / static_cast<double>(outline.size())) * sum);
    mesh.numberOfCells.push_back(CellsWithinWall);
    mesh.walls.push_back({ wall.cells });
  }
  return mesh;
}
} // namespace tissue
