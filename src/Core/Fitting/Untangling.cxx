/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/Untangling.h"

#include "Fitting/LoosePoints.h"
#include "Mesh/Crossings.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
namespace
{
/** The share of proposals that are taken where they leave the number of crossings as it is. Some must be, or a point
 * would stay where no single move lowers it; with all of them points would drift. */
constexpr double TieShare = 0.3;

/** The pairs of triangles, close or not, that the search may look at, or for each triangle of the mesh if that is more.
 * Stars of tissues need up to 950 a triangle, small ones of odd shapes up to 14 million in all; one of noise, which
 * cannot be untangled, would take hours without a limit. */
constexpr std::int64_t MostTests = 16000000;
constexpr std::int64_t MostTestsPerTriangle = 2000;

/** The corners of the crossing triangles. */
std::set<PointId>
CornersOf(const WallMesh & mesh, const std::vector<TrianglePair> & crossings)
{
  std::set<PointId> points;
  for (const TrianglePair & pair : crossings)
  {
    for (const std::int32_t t : pair)
    {
      points.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
  }
  return points;
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

/** Moves the point to the proposed place where its triangles cross the fewest others; see TieShare for ties. Returns
 * the number of tests of two triangles that this took. */
std::int64_t
Improve(WallMesh & mesh, const LoosePoint & entry, Random & random)
{
  int        best = CountCrossings(mesh, entry);
  const auto testsPerCount = static_cast<std::int64_t>(entry.triangles.size() * entry.close.size());
  if (best == 0)
  {
    return testsPerCount;
  }
  Point                    place = mesh.points[entry.point];
  const std::vector<Point> proposals = Propose(mesh, entry, random);
  for (const Point & proposal : proposals)
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
  return testsPerCount * static_cast<std::int64_t>(proposals.size() + 1);
}
} // namespace

bool
IsHopeless(std::int64_t crossingPairs, const WallMesh & mesh)
{
  return crossingPairs > static_cast<std::int64_t>(mesh.triangles.size());
}

UntanglingCounts
Untangle(WallMesh & mesh, int maximumSweeps, const Execution & execution)
{
  // A local search over the corners of the crossing triangles. They are few, so that all their moves are tested against
  // one list of close triangles, and crossings in the whole mesh are looked for only after each sweep. A sweep searches
  // a few times, as a point's best place depends on where the others went.
  constexpr int      searchesPerSweep = 3;
  const std::int64_t mostTests =
    std::max(MostTests, MostTestsPerTriangle * static_cast<std::int64_t>(mesh.triangles.size()));
  std::int64_t              tests = 0;
  Random                    random(1);
  std::vector<TrianglePair> crossings = FindCrossings(mesh, execution);
  UntanglingCounts          counts;
  counts.before = static_cast<std::int64_t>(crossings.size());
  for (int sweep = 0;
       sweep < maximumSweeps && !crossings.empty() && !IsHopeless(counts.before, mesh) && tests < mostTests;
       ++sweep)
  {
    const std::vector<LoosePoint> loose = CollectLoosePoints(mesh, CornersOf(mesh, crossings));
    for (int i = 0; i < searchesPerSweep; ++i)
    {
      for (std::size_t entry = 0; entry < loose.size() && tests < mostTests; ++entry)
      {
        tests += Improve(mesh, loose[entry], random);
      }
    }
    crossings = FindCrossings(mesh, execution);
  }
  counts.after = static_cast<std::int64_t>(crossings.size());
  return counts;
}
} // namespace tissue
