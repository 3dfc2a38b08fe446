/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CrossingWalls.h"

#include "Fitting/CrossingGuard.h"
#include "Mesh/Crossings.h"
#include "Mesh/WallPieces.h"
#include "Remeshing/WallRemeshing.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <map>
#include <set>
#include <utility>

namespace tissue
{
namespace
{
/** How often walls that cross are smoothed before those that still do are put back, and in how many rounds each time.
 * More of them would part a few walls more, but draw all of these farther from the image. */
constexpr int MostSmoothings = 3;
constexpr int RoundsPerSmoothing = 5;

/** Chooses few walls, but of each pair that crosses at least one that is not in `fixed`.
 *
 * This is the greedy cover of a graph, whose edges are the pairs: the wall of the most partners is taken, which frees
 * its partners of it, and so on until no wall has a partner. */
std::vector<WallId>
ChooseWalls(const WallMesh & mesh, const std::vector<TrianglePair> & crossings, const std::set<WallId> & fixed)
{
  std::map<WallId, std::set<WallId>> partners;
  for (const TrianglePair & pair : crossings)
  {
    const WallId a = mesh.wallOfTriangle[pair[0]];
    const WallId b = mesh.wallOfTriangle[pair[1]];
    if (fixed.count(a) == 0)
    {
      partners[a].insert(b);
    }
    if (fixed.count(b) == 0)
    {
      partners[b].insert(a);
    }
  }
  std::set<std::pair<std::ptrdiff_t, WallId>> byPartners; // Most partners come first, then smaller walls.
  const auto                                  rankOf = [&partners](WallId wall) {
    return std::make_pair(-static_cast<std::ptrdiff_t>(partners.at(wall).size()), wall);
  };
  for (const auto & [wall, others] : partners)
  {
    byPartners.insert(rankOf(wall));
  }
  std::vector<WallId> walls;
  while (!byPartners.empty())
  {
    const WallId wall = byPartners.begin()->second;
    byPartners.erase(byPartners.begin());
    walls.push_back(wall);
    for (const WallId other : partners.at(wall))
    {
      // Fixed walls are not among the partners' keys, and chosen ones not in byPartners any more.
      if (partners.count(other) > 0 && byPartners.erase(rankOf(other)) > 0)
      {
        partners.at(other).erase(wall);
        if (!partners.at(other).empty())
        {
          byPartners.insert(rankOf(other));
        }
      }
    }
  }
  return walls;
}

/** Marks the points of triangles that cross, and those within so many edges of them. */
std::vector<unsigned char>
PointsNear(const WallMesh & mesh, const std::vector<TrianglePair> & crossings, int rings)
{
  std::vector<unsigned char> isNear(mesh.points.size(), 0);
  const auto                 mark = [&](const Triangle & t) {
    for (const PointId p : t)
    {
      isNear[p] = 1;
    }
  };
  for (const TrianglePair & pair : crossings)
  {
    mark(mesh.triangles[pair[0]]);
    mark(mesh.triangles[pair[1]]);
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<unsigned char> before = isNear;
    for (const Triangle & t : mesh.triangles)
    {
      if (before[t[0]] + before[t[1]] + before[t[2]] > 0)
      {
        mark(t);
      }
    }
  }
  return isNear;
}

/** Moves each of these points that is within one of the walls to the mean of its neighbours, in RoundsPerSmoothing
 * rounds. */
void
SmoothWithin(WallMesh & mesh, const std::vector<WallId> & walls, const std::vector<unsigned char> & isMoved)
{
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  for (const WallId wall : walls)
  {
    const WallPiece      piece = CutOutWall(mesh, first[wall], first[wall + 1]);
    WallPatch            patch = MakePatch(mesh, piece);
    std::vector<PointId> pointAt(static_cast<std::size_t>(patch.EndOfVertices()));
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        pointAt[piece.triangles[t][i]] = mesh.triangles[first[wall] + t][i];
      }
    }
    for (int round = 0; round < RoundsPerSmoothing; ++round)
    {
      for (WallPatch::Vertex v = patch.OutlineSize(); v < patch.EndOfVertices(); ++v)
      {
        if (isMoved[pointAt[v]] == 0)
        {
          continue;
        }
        Point sum{ { 0.0, 0.0, 0.0 } };
        int   count = 0;
        patch.ForEachAround(v, [&](WallPatch::HalfEdge h) {
          sum = sum + patch.PointAt(patch.To(h));
          ++count;
        });
        patch.SetPoint(v, (1.0 / count) * sum);
      }
    }
    for (WallPatch::Vertex v = patch.OutlineSize(); v < patch.EndOfVertices(); ++v)
    {
      mesh.points[pointAt[v]] = patch.PointAt(v);
    }
  }
}
} // namespace

std::int64_t
MendCrossingWalls(WallMesh & mesh, const WallMesh & old, SmoothedPoints smoothed, const Execution & execution)
{
  // Each time at least one wall of every crossing pair changes, so whatever crosses after it has a changed wall.
  std::vector<TrianglePair> crossings = FindCrossings(mesh, execution);
  std::vector<WallId>       walls = ChooseWalls(mesh, crossings, {});
  for (int i = 0; i < MostSmoothings && !walls.empty(); ++i)
  {
    SmoothWithin(mesh,
                 walls,
                 smoothed == SmoothedPoints::WholeWalls ? std::vector<unsigned char>(mesh.points.size(), 1)
                                                        : PointsNear(mesh, crossings, i));
    crossings = FindCrossingsOfWalls(mesh, walls, execution);
    walls = ChooseWalls(mesh, crossings, {});
  }
  std::set<WallId> putBack;
  while (!walls.empty())
  {
    putBack.insert(walls.begin(), walls.end());
    ReplaceWalls(mesh, old, walls);
    walls = ChooseWalls(mesh, FindCrossingsOfWalls(mesh, walls, execution), putBack);
  }
  return static_cast<std::int64_t>(putBack.size());
}
} // namespace tissue
