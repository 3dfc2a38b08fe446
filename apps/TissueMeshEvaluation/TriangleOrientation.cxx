/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueMeshEvaluation/TriangleOrientation.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace tissue
{
namespace
{
using SidedTriangle = TrianglesOfLabels::Triangle;

/** Two triangles of a cell at an edge, and whether they run along it in the same direction, as seen from the cell. */
struct Neighbors
{
  std::size_t a;
  std::size_t b;
  bool        areAlike;
};

std::vector<Neighbors>
FindNeighbors(const TrianglesOfLabels & mesh, const std::vector<PointId> & places, const std::set<Label> & exterior)
{
  // Label, edge, triangle, and whether it runs from the edge's smaller point to its larger one, seen from the cell.
  std::vector<std::tuple<Label, PointId, PointId, std::size_t, bool>> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const SidedTriangle & triangle = mesh.triangles[t];
    for (int side = 0; side < 2; ++side)
    {
      for (int i = 0; i < 3 && exterior.count(triangle.labels[side]) == 0; ++i)
      {
        const PointId from = places[static_cast<std::size_t>(triangle.points[i])];
        const PointId to = places[static_cast<std::size_t>(triangle.points[(i + 1) % 3])];
        edges.emplace_back(
          triangle.labels[side], std::min(from, to), std::max(from, to), t, (from < to) == (side == 0));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto isSameEdge = [&](std::size_t i, std::size_t j) {
    return std::get<0>(edges[i]) == std::get<0>(edges[j]) && std::get<1>(edges[i]) == std::get<1>(edges[j]) &&
           std::get<2>(edges[i]) == std::get<2>(edges[j]);
  };
  std::vector<Neighbors> neighbors;
  for (std::size_t i = 0; i < edges.size();)
  {
    std::size_t end = i + 1;
    while (end < edges.size() && isSameEdge(i, end))
    {
      ++end;
    }
    if (end == i + 2)
    {
      neighbors.push_back(
        { std::get<3>(edges[i]), std::get<3>(edges[i + 1]), std::get<4>(edges[i]) == std::get<4>(edges[i + 1]) });
    }
    i = end;
  }
  return neighbors;
}

/** \brief Sets of triangles, each with whether it is to be turned relative to the first of its set. */
class TurnSets
{
public:
  explicit TurnSets(std::size_t size)
    : m_Parents(size)
    , m_IsTurned(size, false)
  {
    std::iota(m_Parents.begin(), m_Parents.end(), std::size_t{ 0 });
  }

  /** The first of the set, and whether the triangle is turned relative to it. */
  std::pair<std::size_t, bool>
  Find(std::size_t t)
  {
    std::vector<std::size_t> path;
    for (; m_Parents[t] != t; t = m_Parents[t])
    {
      path.push_back(t);
    }
    bool isTurned = false;
    for (auto at = path.rbegin(); at != path.rend(); ++at)
    {
      isTurned = isTurned != m_IsTurned[*at];
      m_IsTurned[*at] = isTurned;
      m_Parents[*at] = t;
    }
    return { t, isTurned };
  }

  void
  Join(const Neighbors & pair)
  {
    const auto [a, isTurnedA] = this->Find(pair.a);
    const auto [b, isTurnedB] = this->Find(pair.b);
    if (a != b)
    {
      m_Parents[b] = a;
      m_IsTurned[b] = (isTurnedA != isTurnedB) != pair.areAlike;
    }
  }

private:
  std::vector<std::size_t> m_Parents;
  std::vector<bool>        m_IsTurned;
};

/** What a triangle adds to six times the sum of the cells' volumes. */
double
VolumeOf(const SidedTriangle & triangle, const TrianglesOfLabels & mesh, const std::set<Label> & exterior)
{
  const auto & [a, b, c] = triangle.points;
  const double volume = Dot(mesh.points[a], Cross(mesh.points[b], mesh.points[c]));
  return (exterior.count(triangle.labels[0]) == 0 ? volume : 0.0) -
         (exterior.count(triangle.labels[1]) == 0 ? volume : 0.0);
}

void
TurnUntilAlike(TrianglesOfLabels & mesh, const std::vector<Neighbors> & neighbors, const std::set<Label> & exterior)
{
  TurnSets sets(mesh.triangles.size());
  for (const Neighbors & pair : neighbors)
  {
    sets.Join(pair);
  }
  std::map<std::size_t, double> volumeOfSet;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto [set, isTurned] = sets.Find(t);
    volumeOfSet[set] += (isTurned ? -1.0 : 1.0) * VolumeOf(mesh.triangles[t], mesh, exterior);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto [set, isTurned] = sets.Find(t);
    if (isTurned != (volumeOfSet.at(set) < 0.0))
    {
      std::swap(mesh.triangles[t].points[1], mesh.triangles[t].points[2]);
    }
  }
}
} // namespace

std::vector<std::string>
OrientByLabels(TrianglesOfLabels & mesh, const std::vector<PointId> & places, const std::set<Label> & exterior)
{
  const std::vector<Neighbors> neighbors = FindNeighbors(mesh, places, exterior);
  const auto                   numberOfFaults = static_cast<std::size_t>(
    std::count_if(neighbors.begin(), neighbors.end(), [](const Neighbors & pair) { return pair.areAlike; }));
  if (10 * numberOfFaults > neighbors.size())
  {
    TurnUntilAlike(mesh, neighbors, exterior);
    return { "the sides of the polygons do not follow their labels: they are turned so that they do" };
  }
  double volume = 0.0;
  for (const SidedTriangle & triangle : mesh.triangles)
  {
    volume += VolumeOf(triangle, mesh, exterior);
  }
  // Points that are not finite are refused by who judges the mesh.
  if (!(volume < 0.0))
  {
    return {};
  }
  for (SidedTriangle & triangle : mesh.triangles)
  {
    std::swap(triangle.labels[0], triangle.labels[1]);
  }
  return { "the normals of the polygons point from the second label to the first: the labels change places" };
}
} // namespace tissue
