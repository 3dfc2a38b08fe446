/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallPieces.h"

#include "Common/Algorithms.h"

#include <algorithm>
#include <stdexcept>

namespace tissue
{
std::vector<std::size_t>
FirstTrianglesOfWalls(const WallMesh & mesh)
{
  if (!std::is_sorted(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end()))
  {
    throw std::invalid_argument("The triangles of the wall mesh are not in the order of its walls");
  }
  std::vector<std::size_t> first;
  auto                     at = mesh.wallOfTriangle.begin();
  for (std::size_t w = 0; w <= mesh.walls.size(); ++w)
  {
    at = std::lower_bound(at, mesh.wallOfTriangle.end(), static_cast<WallId>(w));
    first.push_back(static_cast<std::size_t>(at - mesh.wallOfTriangle.begin()));
  }
  return first;
}

WallPiece
CutOutWall(const WallMesh & mesh, std::size_t firstTriangle, std::size_t endTriangle)
{
  std::vector<PointId> points;
  points.reserve(3 * (endTriangle - firstTriangle));
  for (std::size_t t = firstTriangle; t < endTriangle; ++t)
  {
    points.insert(points.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  }
  SortUnique(points);
  const auto interior = std::stable_partition(
    points.begin(), points.end(), [&](PointId p) { return mesh.numberOfCells[p] > CellsWithinWall; });

  WallPiece piece;
  for (auto p = interior; p != points.end(); ++p)
  {
    piece.interior.push_back(mesh.points[*p]);
  }
  const auto numberOf = [&](PointId p) {
    const bool outside = mesh.numberOfCells[p] > CellsWithinWall;
    const auto at =
      outside ? std::lower_bound(points.begin(), interior, p) : std::lower_bound(interior, points.end(), p);
    return static_cast<std::int32_t>(at - points.begin());
  };
  for (std::size_t t = firstTriangle; t < endTriangle; ++t)
  {
    const auto & triangle = mesh.triangles[t];
    piece.triangles.push_back({ { numberOf(triangle[0]), numberOf(triangle[1]), numberOf(triangle[2]) } });
  }
  piece.outline.assign(points.begin(), interior);
  return piece;
}

WallPatch
MakePatch(const WallMesh & mesh, const WallPiece & piece)
{
  std::vector<Point> points;
  points.reserve(piece.outline.size() + piece.interior.size());
  for (const PointId p : piece.outline)
  {
    points.push_back(mesh.points[p]);
  }
  points.insert(points.end(), piece.interior.begin(), piece.interior.end());
  return WallPatch(std::move(points), piece.triangles, static_cast<WallPatch::Vertex>(piece.outline.size()));
}

void
TakePatch(const WallPatch & patch, WallPiece & piece)
{
  piece.triangles = patch.Triangles();
  piece.interior.clear();
  for (WallPatch::Vertex v = patch.OutlineSize(); v < patch.EndOfVertices(); ++v)
  {
    piece.interior.push_back(patch.PointAt(v));
  }
}

namespace
{
/** Room for the points outside of the pieces, and all that is in them. */
void
Reserve(WallMesh & mesh, std::size_t numberOfPoints, const std::vector<WallPiece> & pieces)
{
  std::size_t numberOfTriangles = 0;
  for (const WallPiece & piece : pieces)
  {
    numberOfPoints += piece.interior.size();
    numberOfTriangles += piece.triangles.size();
  }
  mesh.points.reserve(numberOfPoints);
  mesh.numberOfCells.reserve(numberOfPoints);
  mesh.triangles.reserve(numberOfTriangles);
  mesh.wallOfTriangle.reserve(numberOfTriangles);
}
} // namespace

WallMesh
JoinWallPieces(const WallMesh & mesh, const std::vector<WallPiece> & pieces)
{
  WallMesh             joined;
  std::vector<PointId> numberOf(mesh.points.size(), -1);
  joined.walls = mesh.walls;
  Reserve(joined,
          mesh.points.size() -
            static_cast<std::size_t>(std::count(mesh.numberOfCells.begin(), mesh.numberOfCells.end(), CellsWithinWall)),
          pieces);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    if (mesh.numberOfCells[p] > CellsWithinWall)
    {
      numberOf[p] = static_cast<PointId>(joined.points.size());
      joined.points.push_back(mesh.points[p]);
      joined.numberOfCells.push_back(mesh.numberOfCells[p]);
    }
  }
  for (std::size_t w = 0; w < pieces.size(); ++w)
  {
    const WallPiece & piece = pieces[w];
    const auto        firstInterior = static_cast<PointId>(joined.points.size());
    const auto        outlineSize = static_cast<std::int32_t>(piece.outline.size());
    for (const auto & triangle : piece.triangles)
    {
      std::array<PointId, 3> points;
      for (int i = 0; i < 3; ++i)
      {
        points[i] =
          triangle[i] < outlineSize ? numberOf[piece.outline[triangle[i]]] : firstInterior + triangle[i] - outlineSize;
      }
      joined.triangles.push_back(points);
      joined.wallOfTriangle.push_back(static_cast<WallId>(w));
    }
    joined.points.insert(joined.points.end(), piece.interior.begin(), piece.interior.end());
    joined.numberOfCells.resize(joined.points.size(), CellsWithinWall);
  }
  return joined;
}
} // namespace tissue
