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
#include "TissueTessellationCore/Vector.h"
#include "TissueTessellationCore/WallEdgeLengths.h"
#include "TissueTessellationCore/WallLines.h"
#include "TissueTessellationCore/WallPieces.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace tissue
{
namespace
{
void
RemeshPiece(const WallMesh & mesh, const WallsAtPoints & wallsAt, double edgeLength, WallPiece & piece)
{
  const WallPatch patch = MakePatch(mesh, piece);
  PatchRemesher   remesher(patch, [&](WallPatch::Vertex a, WallPatch::Vertex b) {
    return wallsAt.CountCommon(piece.outline[a], piece.outline[b]) == 1;
  });
  remesher.Remesh(NumberOfInteriorPoints(AreaOf(patch), edgeLength, static_cast<int>(piece.outline.size())));
  TakePatch(remesher.TakePatch(), piece);
}

/** The edges of a patch that can be split, longest first. */
class LongestEdges
{
public:
  using HalfEdge = WallPatch::HalfEdge;

  explicit LongestEdges(const WallPatch & patch)
    : m_Patch(patch)
  {
    for (HalfEdge h = 0; h < patch.EndOfHalfEdges(); ++h)
    {
      this->Push(h);
    }
  }

  void
  Push(HalfEdge h)
  {
    if (m_Patch.Twin(h) != WallPatch::None)
    {
      m_Edges.emplace(this->LengthOf(h), std::max(h, m_Patch.Twin(h)));
    }
  }

  /** WallPatch::None where there is none left. */
  HalfEdge
  Pop()
  {
    while (!m_Edges.empty())
    {
      const auto [length, h] = m_Edges.top();
      m_Edges.pop();
      // A half-edge that was split goes on as a shorter one.
      if (length == this->LengthOf(h))
      {
        return h;
      }
    }
    return WallPatch::None;
  }

private:
  double
  LengthOf(HalfEdge h) const
  {
    return Distance(m_Patch.PointAt(m_Patch.From(h)), m_Patch.PointAt(m_Patch.To(h)));
  }

  const WallPatch &                                m_Patch;
  std::priority_queue<std::pair<double, HalfEdge>> m_Edges;
};

void
SubdividePiece(const WallMesh & mesh, double edgeLength, WallPiece & piece)
{
  WallPatch    patch = MakePatch(mesh, piece);
  LongestEdges edges(patch);
  int          missing = NumberOfInteriorPoints(AreaOf(patch), edgeLength, static_cast<int>(piece.outline.size())) -
                patch.NumberOfInteriorVertices();
  for (WallPatch::HalfEdge h = 0; missing > 0 && (h = edges.Pop()) != WallPatch::None; --missing)
  {
    const Point             middle = 0.5 * (patch.PointAt(patch.From(h)) + patch.PointAt(patch.To(h)));
    const WallPatch::Vertex v = patch.Split(h, middle);
    patch.ForEachAround(v, [&](WallPatch::HalfEdge around) {
      edges.Push(around);
      edges.Push(WallPatch::Next(around));
    });
  }
  patch.Compact();
  TakePatch(patch, piece);
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

void
SubdivideWalls(WallMesh & mesh, const std::vector<double> & edgeLengths, const ParallelFor & parallelFor)
{
  RequireEdgeLengths(mesh, edgeLengths);
  std::vector<WallPiece> pieces = CutOutWalls(mesh);
  RunFor(parallelFor, pieces.size(), [&](std::size_t w) { SubdividePiece(mesh, edgeLengths[w], pieces[w]); });
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
