/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/CrossingWalls.h"

#include "TissueTessellationCore/CrossingGuard.h"
#include "TissueTessellationCore/Vector.h"
#include "TissueTessellationCore/WallPieces.h"
#include "TissueTessellationCore/WallRemeshing.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace tissue
{
namespace
{
constexpr int MostSmoothings = 3;
constexpr int RoundsPerSmoothing = 5;

/** Few walls, at least one of each pair that crosses but none of `fixed`: those that cross most come first. */
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
  std::vector<WallId> walls;
  while (!partners.empty())
  {
    const auto   most = std::max_element(partners.begin(), partners.end(), [](const auto & one, const auto & other) {
      return one.second.size() < other.second.size();
    });
    const WallId wall = most->first;
    walls.push_back(wall);
    partners.erase(most);
    for (auto at = partners.begin(); at != partners.end();)
    {
      at->second.erase(wall);
      at = at->second.empty() ? partners.erase(at) : std::next(at);
    }
  }
  return walls;
}

/** Moves each point within the walls to the mean of its neighbours, in some rounds. */
void
SmoothWithin(WallMesh & mesh, const std::vector<WallId> & walls)
{
  std::vector<WallPiece> pieces = CutOutWalls(mesh);
  for (const WallId wall : walls)
  {
    WallPatch patch = MakePatch(mesh, pieces[wall]);
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
    TakePatch(patch, pieces[wall]);
  }
  mesh = JoinWallPieces(mesh, pieces);
}
} // namespace

std::int64_t
MendCrossingWalls(WallMesh & mesh, const WallMesh & old, const ParallelFor & parallelFor)
{
  // Whatever still crosses after a change is one of the walls that were chosen, each time.
  std::vector<WallId> walls = ChooseWalls(mesh, FindCrossings(mesh, parallelFor), {});
  for (int i = 0; i < MostSmoothings && !walls.empty(); ++i)
  {
    SmoothWithin(mesh, walls);
    walls = ChooseWalls(mesh, FindCrossingsOfWalls(mesh, walls, parallelFor), {});
  }
  std::set<WallId> putBack;
  while (!walls.empty())
  {
    putBack.insert(walls.begin(), walls.end());
    ReplaceWalls(mesh, old, walls);
    walls = ChooseWalls(mesh, FindCrossingsOfWalls(mesh, walls, parallelFor), putBack);
  }
  return static_cast<std::int64_t>(putBack.size());
}
} // namespace tissue
