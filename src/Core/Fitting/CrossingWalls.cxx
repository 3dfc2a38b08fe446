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
  std::set<std::pair<std::ptrdiff_t, WallId>> byPartners; // most first, then the smaller wall
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
      // Neither a fixed wall nor one that is chosen already.
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

/** Moves each point within the walls to the mean of its neighbours, in some rounds. */
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
  // Whatever still crosses after a change is one of the walls that were chosen, each time.
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
