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

/** Moves each point within the walls to the mean of its neighbours, in RoundsPerSmoothing rounds. */
void
SmoothWithin(WallMesh & mesh, const std::vector<WallId> & walls)
{
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  for (const WallId wall : walls)
  {
    const WallPiece piece = CutOutWall(mesh, first[wall], first[wall + 1]);
    WallPatch       patch = MakePatch(mesh, piece);
    for (int round = 0; round < RoundsPerSmoothing; ++round)
    {
      for (WallPatch::Vertex v = patch.OutlineSize(); v < patch.EndOfVertices(); ++v)
      {
        Point sum{ { 0.0, 0.0, 0.0 } };
        int   count = 0;
        patch.ForEachAround(v, [&](WallPatch::HalfEdge h) {
          sum = sum + patch.PointAt(patch.To(h));
          ++count;
        });
        patch.SetPoint(v, (1.0 / count) * sum);
      }
    }
    for (std::size_t t = 0; t < piece.triangles.size(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        mesh.points[mesh.triangles[first[wall] + t][i]] = patch.PointAt(piece.triangles[t][i]);
      }
    }
  }
}
} // namespace

std::int64_t
MendCrossingWalls(WallMesh & mesh, const WallMesh & old, const Execution & execution)
{
  // Each time at least one wall of every crossing pair changes, so whatever crosses after it has a changed wall.
  std::vector<WallId> walls = ChooseWalls(mesh, FindCrossings(mesh, execution), {});
  for (int i = 0; i < MostSmoothings && !walls.empty(); ++i)
  {
    SmoothWithin(mesh, walls);
    walls = ChooseWalls(mesh, FindCrossingsOfWalls(mesh, walls, execution), {});
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
