/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/TissueParts.h"

#include "TissueTessellationCore/DisjointSets.h"
#include "TissueTessellationCore/ExactPredicates.h"
#include "TissueTessellationCore/Vector.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** Whether the centres of the cells span the space, so that they have a tetrahedralization. */
bool
CanBeComplex(const std::vector<VertexId> & cells, const std::vector<Point> & centers)
{
  std::vector<Point> points;
  for (const VertexId cell : cells)
  {
    points.push_back(centers[cell]);
  }
  return !AreCoplanar(points);
}

std::vector<std::vector<VertexId>>
ConnectByJunctions(const JunctionSet & junctions)
{
  DisjointSets sets(junctions.cells.size());
  for (const Junction & junction : junctions.junctions)
  {
    const VertexId last = junction.cells[3];
    for (const VertexId v : junction.cells)
    {
      if (v != ExteriorVertex)
      {
        sets.Unite(v, last);
      }
    }
  }
  std::map<std::int64_t, std::vector<VertexId>> byRoot;
  for (std::size_t v = ExteriorVertex + 1; v < junctions.cells.size(); ++v)
  {
    byRoot[sets.Find(static_cast<std::int64_t>(v))].push_back(static_cast<VertexId>(v));
  }
  std::vector<std::vector<VertexId>> parts;
  for (auto & entry : byRoot)
  {
    parts.push_back(std::move(entry.second));
  }
  std::sort(parts.begin(), parts.end(), [](const auto & a, const auto & b) {
    return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
  });
  return parts;
}

/** The part that holds the cell nearest to the given one. */
std::size_t
NearestPart(VertexId cell, const std::vector<std::vector<VertexId>> & parts, const std::vector<Point> & centers)
{
  std::size_t nearest = 0;
  double      least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (const VertexId other : parts[p])
    {
      const double distance = Distance(centers[cell], centers[other]);
      if (distance < least)
      {
        least = distance;
        nearest = p;
      }
    }
  }
  return nearest;
}
} // namespace

TissueParts
FindTissueParts(const JunctionSet & junctions, const std::vector<Point> & centers)
{
  TissueParts                        result;
  std::vector<std::vector<VertexId>> large;
  for (std::vector<VertexId> & part : ConnectByJunctions(junctions))
  {
    if (CanBeComplex(part, centers))
    {
      large.push_back(std::move(part));
    }
    else
    {
      result.strayCells.insert(result.strayCells.end(), part.begin(), part.end());
    }
  }
  std::sort(result.strayCells.begin(), result.strayCells.end());
  if (large.empty())
  {
    result.parts.push_back(std::move(result.strayCells));
    result.strayCells.clear();
    return result;
  }
  result.parts = large;
  for (const VertexId cell : result.strayCells)
  {
    result.parts[NearestPart(cell, large, centers)].push_back(cell);
  }
  for (std::vector<VertexId> & part : result.parts)
  {
    std::sort(part.begin(), part.end());
  }
  return result;
}

TissueParts
JoinTissueParts(const JunctionSet & junctions)
{
  TissueParts result;
  result.parts.emplace_back();
  for (std::size_t v = ExteriorVertex + 1; v < junctions.cells.size(); ++v)
  {
    result.parts.front().push_back(static_cast<VertexId>(v));
  }
  return result;
}
} // namespace tissue
