/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/WallRemeshing.h"

#include "Mesh/WallLines.h"
#include "Mesh/WallMeshOrder.h"
#include "Mesh/WallPatch.h"
#include "Mesh/WallPieces.h"
#include "Remeshing/LineSubdivision.h"
#include "Remeshing/PatchRemesher.h"
#include "Remeshing/WallEdgeLengths.h"
#include "TissueTessellationCore/Geometry/Vector.h"

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

/** The edges of a patch that can be split, the longest first. */
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

  /** Takes the longest edge and returns it, or WallPatch::None where there is none left. */
  HalfEdge
  Pop()
  {
    while (!m_Edges.empty())
    {
      const auto [length, h] = m_Edges.top();
      m_Edges.pop();
      // A half-edge that was split goes on as a shorter one, which has an entry of its own.
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

/** Cuts the mesh into one piece for each wall, calls change(w, piece) with each, and joins the changed pieces. */
template <typename TChange>
void
ChangeWalls(WallMesh & mesh, const Execution & execution, const TChange & change)
{
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  std::vector<WallPiece>         pieces(mesh.walls.size());
  execution.For(pieces.size(), [&](std::size_t w) {
    pieces[w] = CutOutWall(mesh, first[w], first[w + 1]);
    change(w, pieces[w]);
  });
  mesh = JoinWallPieces(mesh, pieces);
}
} // namespace

void
RemeshWalls(WallMesh & mesh, const std::vector<double> & edgeLengths, const Execution & execution)
{
  RequireEdgeLengths(mesh, edgeLengths);
  const WallsAtPoints wallsAt(mesh);
  ChangeWalls(
    mesh, execution, [&](std::size_t w, WallPiece & piece) { RemeshPiece(mesh, wallsAt, edgeLengths[w], piece); });
}

void
SubdivideWalls(WallMesh & mesh, const std::vector<double> & edgeLengths, const Execution & execution)
{
  RequireEdgeLengths(mesh, edgeLengths);
  ChangeWalls(mesh, execution, [&](std::size_t w, WallPiece & piece) { SubdividePiece(mesh, edgeLengths[w], piece); });
}

std::vector<double>
RemeshToNumberOfTriangles(WallMesh & mesh, double numberOfTriangles, const std::vector<double> & factors,
                          const Execution & execution)
{
  // At most so many meshings are made, and the number of triangles may be off by this share of the wanted one. What
  // comes of the walls is known only once they are remeshed, but its ratio to what was ordered changes little.
  constexpr int    tries = 3;
  constexpr double tolerance = 0.02;
  const WallMesh   before = mesh;
  double           ordered = numberOfTriangles;
  for (int i = 1;; ++i)
  {
    mesh = before;
    std::vector<double> edgeLengths = ChooseEdgeLengths(mesh, ordered, factors);
    SubdivideLines(mesh, edgeLengths);
    RemeshWalls(mesh, edgeLengths, execution);
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
  // The walls' triangles are collected from the one mesh or the other, wall by wall. The points within walls that the
  // other mesh brings are appended, and get new numbers when they are first met.
  std::vector<unsigned char> isReplaced(mesh.walls.size(), 0);
  for (const WallId w : walls)
  {
    isReplaced[w] = 1;
  }
  const std::vector<std::size_t> firstOfMesh = FirstTrianglesOfWalls(mesh);
  const std::vector<std::size_t> firstOfOther = FirstTrianglesOfWalls(other);
  std::vector<PointId>           numberOf(other.points.size(), -1);
  // The points of corners and lines have the same numbers in both meshes.
  const auto takePoint = [&](PointId & p) {
    if (other.numberOfCells[p] != CellsWithinWall)
    {
      return;
    }
    if (numberOf[p] < 0)
    {
      numberOf[p] = static_cast<PointId>(mesh.points.size());
      mesh.points.push_back(other.points[p]);
      mesh.numberOfCells.push_back(CellsWithinWall);
    }
    p = numberOf[p];
  };
  std::vector<Triangle> triangles;
  std::vector<WallId>   wallOfTriangle;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    const auto & source = isReplaced[w] != 0 ? other.triangles : mesh.triangles;
    const auto & first = isReplaced[w] != 0 ? firstOfOther : firstOfMesh;
    for (std::size_t t = first[w]; t < first[w + 1]; ++t)
    {
      triangles.push_back(source[t]);
      wallOfTriangle.push_back(static_cast<WallId>(w));
      if (isReplaced[w] != 0)
      {
        std::for_each(triangles.back().begin(), triangles.back().end(), takePoint);
      }
    }
  }
  mesh.triangles = std::move(triangles);
  mesh.wallOfTriangle = std::move(wallOfTriangle);
  PutLinePointsFirst(mesh);
}
} // namespace tissue
