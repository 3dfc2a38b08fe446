/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/Untangling.h"

#include "Fitting/CrossingGuard.h"
#include "Geometry/BoxGrid.h"
#include "Geometry/TriangleCrossing.h"
#include "Mesh/Crossings.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <map>
#include <set>

namespace tissue
{
namespace
{
/** The share of proposals that are taken where they leave the number of crossings as it is. Some must be, or a point
 * would stay where no single move lowers it; with all of them points would drift. */
constexpr double TieShare = 0.3;

/** A point that may move: the box that it stays in, about its triangles; these triangles; their other points, one entry
 * for each triangle; and all triangles that its own can come to cross. */
struct LoosePoint
{
  PointId                   point = -1;
  Box                       reach{};
  std::vector<std::int32_t> triangles;
  std::vector<PointId>      neighbors;
  std::vector<std::int32_t> close;
};

/** Makes a loose point of each corner of the crossing triangles, and collects its triangles, its neighbours and its box
 * in one pass over the mesh. */
std::vector<LoosePoint>
CollectLoosePoints(const WallMesh & mesh, const std::vector<TrianglePair> & crossings)
{
  std::set<PointId> points;
  for (const TrianglePair & pair : crossings)
  {
    for (const std::int32_t t : pair)
    {
      points.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
  }
  std::map<PointId, LoosePoint> loose;
  for (const PointId p : points)
  {
    loose[p].point = p;
    loose[p].reach = { mesh.points[p], mesh.points[p] };
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      const auto at = loose.find(p);
      if (at == loose.end())
      {
        continue;
      }
      at->second.triangles.push_back(static_cast<std::int32_t>(t));
      for (const PointId q : mesh.triangles[t])
      {
        Extend(at->second.reach, mesh.points[q]);
        if (q != p)
        {
          at->second.neighbors.push_back(q);
        }
      }
    }
  }
  std::vector<LoosePoint> result;
  for (auto & [p, entry] : loose)
  {
    result.push_back(std::move(entry));
  }
  return result;
}

/** Finds the triangles that each loose point's own can come to cross while all loose points stay within their reach.
 *
 * These are the triangles whose box, extended by the reach of their own loose points, overlaps the point's reach. One
 * grid holds the boxes of all triangles and, after them, the reaches. */
void
FindClose(const WallMesh & mesh, std::vector<LoosePoint> & loose)
{
  const auto       numberOfTriangles = static_cast<std::int32_t>(mesh.triangles.size());
  std::vector<Box> boxes;
  for (const auto & triangle : mesh.triangles)
  {
    boxes.push_back(BoxOfTriangle(mesh.points, triangle));
  }
  for (const LoosePoint & entry : loose)
  {
    for (const std::int32_t t : entry.triangles)
    {
      Extend(boxes[t], entry.reach.lower);
      Extend(boxes[t], entry.reach.upper);
    }
  }
  for (const LoosePoint & entry : loose)
  {
    boxes.push_back(entry.reach);
  }
  const BoxGrid grid(boxes);
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      if (a < numberOfTriangles && b >= numberOfTriangles)
      {
        loose[b - numberOfTriangles].close.push_back(a);
      }
    });
  }
}

/** Counts the pairs of one of the point's triangles and a close one that cross as they are now. */
int
CountCrossings(const WallMesh & mesh, const LoosePoint & entry)
{
  int count = 0;
  for (const std::int32_t t : entry.triangles)
  {
    const auto & triangle = mesh.triangles[t];
    const Box    box = BoxOfTriangle(mesh.points, triangle);
    for (const std::int32_t other : entry.close)
    {
      const auto & o = mesh.triangles[other];
      count +=
        other != t && Overlap(box, BoxOfTriangle(mesh.points, o)) && TrianglesCross(mesh.points, triangle, o) ? 1 : 0;
    }
  }
  return count;
}

/** Proposes eight places for a point: the mean of its neighbours, halfway to it, and two at random in each of three
 * cubes about it, whose half edges are 5 %, 15 % and 50 % of the mean length of its edges. */
std::vector<Point>
Propose(const WallMesh & mesh, const LoosePoint & entry, Random & random)
{
  const Point  old = mesh.points[entry.point];
  Point        mean{ { 0.0, 0.0, 0.0 } };
  double       length = 0.0;
  const double share = 1.0 / static_cast<double>(entry.neighbors.size());
  for (const PointId q : entry.neighbors)
  {
    mean = mean + share * mesh.points[q];
    length += share * Distance(old, mesh.points[q]);
  }
  std::vector<Point> proposals{ mean, 0.5 * (old + mean) };
  for (const double scale : { 0.05, 0.05, 0.15, 0.15, 0.5, 0.5 })
  {
    Point p = old;
    for (int i = 0; i < 3; ++i)
    {
      p[i] += scale * length * (2.0 * random.Uniform() - 1.0);
      p[i] = std::clamp(p[i], entry.reach.lower[i], entry.reach.upper[i]);
    }
    proposals.push_back(p);
  }
  return proposals;
}

/** Moves the point to the proposed place where its triangles cross the fewest others; see TieShare for ties. */
void
Improve(WallMesh & mesh, const LoosePoint & entry, Random & random)
{
  int best = CountCrossings(mesh, entry);
  if (best == 0)
  {
    return;
  }
  Point place = mesh.points[entry.point];
  for (const Point & proposal : Propose(mesh, entry, random))
  {
    mesh.points[entry.point] = proposal;
    const int count = CountCrossings(mesh, entry);
    if (count < best || (count == best && random.Uniform() < TieShare))
    {
      best = count;
      place = proposal;
    }
  }
  mesh.points[entry.point] = place;
}
} // namespace

std::int64_t
Untangle(WallMesh & mesh, int maximumSweeps, const Execution & execution)
{
  // A local search over the corners of the crossing triangles. They are few, so that all their moves are tested against
  // one list of close triangles, and crossings in the whole mesh are looked for only after each sweep. A sweep searches
  // a few times, as a point's best place depends on where the others went.
  constexpr int             searchesPerSweep = 3;
  Random                    random(1);
  std::vector<TrianglePair> crossings = FindCrossings(mesh, execution);
  for (int sweep = 0; sweep < maximumSweeps && !crossings.empty(); ++sweep)
  {
    std::vector<LoosePoint> loose = CollectLoosePoints(mesh, crossings);
    FindClose(mesh, loose);
    for (int i = 0; i < searchesPerSweep; ++i)
    {
      for (const LoosePoint & entry : loose)
      {
        Improve(mesh, entry, random);
      }
    }
    crossings = FindCrossings(mesh, execution);
  }
  return static_cast<std::int64_t>(crossings.size());
}
} // namespace tissue
