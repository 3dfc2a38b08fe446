/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/WallRemeshing.h"

#include "TissueTessellationCore/LineSubdivision.h"
#include "TissueTessellationCore/PatchMeasures.h"
#include "TissueTessellationCore/PatchRemesher.h"
#include "TissueTessellationCore/WallLines.h"
#include "TissueTessellationCore/WallEdgeLengths.h"
#include "TissueTessellationCore/WallPieces.h"

#include <cmath>

namespace tissue
{
namespace
{
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
RemeshPiece(const WallMesh & mesh, const WallsAtPoints & wallsAt, double edgeLength, WallPiece & piece)
{
  const WallPatch patch = MakePatch(mesh, piece);
  PatchRemesher   remesher(patch, [&](WallPatch::Vertex a, WallPatch::Vertex b) {
    return wallsAt.CountCommon(piece.outline[a], piece.outline[b]) == 1;
  });
  remesher.Remesh(NumberOfInteriorPoints(AreaOf(patch), edgeLength, static_cast<int>(piece.outline.size())));
  const WallPatch remeshed = remesher.TakePatch();
  piece.triangles = remeshed.Triangles();
  piece.interior.clear();
  for (WallPatch::Vertex v = remeshed.OutlineSize(); v < remeshed.EndOfVertices(); ++v)
  {
    piece.interior.push_back(remeshed.PointAt(v));
  }
}
} // namespace

void
RemeshWalls(WallMesh & mesh, const std::vector<double> & edgeLengths, const ParallelFor & parallelFor)
{
  RequireEdgeLengths(mesh, edgeLengths);
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  const WallsAtPoints            wallsAt(mesh);
  std::vector<WallPiece>         pieces(mesh.walls.size());
  RunFor(parallelFor, pieces.size(), [&](std::size_t w) {
    pieces[w] = CutOutWall(mesh, first[w], first[w + 1]);
    RemeshPiece(mesh, wallsAt, edgeLengths[w], pieces[w]);
  });
  mesh = JoinWallPieces(mesh, pieces);
}

std::vector<double>
RemeshToNumberOfTriangles(WallMesh & mesh, double numberOfTriangles, const std::vector<double> & factors,
                          const ParallelFor & parallelFor)
{
  constexpr int    tries = 3;
  constexpr double tolerance = 0.02;
  const WallMesh   before = mesh;
  double           ordered = numberOfTriangles;
  for (int i = 1;; ++i)
  {
    mesh = before;
    std::vector<double> edgeLengths = ChooseEdgeLengths(mesh, ordered, factors);
    SubdivideLines(mesh, edgeLengths);
    RemeshWalls(mesh, edgeLengths, parallelFor);
    const double ratio = static_cast<double>(mesh.triangles.size()) / numberOfTriangles;
    if (i == tries || std::abs(ratio - 1.0) <= tolerance)
    {
      return edgeLengths;
    }
    ordered /= ratio;
  }
}

void
ReplaceWalls(WallMesh & mesh, const WallMesh & other, const std::vector<WallId> & walls)
{
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(other);
  std::vector<WallPiece>         pieces = CutOutWalls(mesh);
  for (const WallId w : walls)
  {
    pieces[w] = CutOutWall(other, first[w], first[w + 1]);
  }
  mesh = JoinWallPieces(mesh, pieces);
}
} // namespace tissue
