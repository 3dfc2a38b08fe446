/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Adjacency/TissueParts.h"

#include "Geometry/ExactPredicates.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** Whether the centres of the cells do not lie in one plane, so that they have a tetrahedralization. */
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

/** Returns the sets of cells that junctions connect, each ascending, the largest set first. */
std::vector<std::vector<VertexId>>
ConnectByJunctions(const JunctionSet & junctions)
{
  DisjointSets sets(junctions.cells.size());
  for (const Junction & junction : junctions.junctions)
  {
    const VertexId first = junction.cells[junction.cells[0] == ExteriorVertex ? 1 : 0];
    for (const VertexId v : junction.cells)
    {
      if (v != ExteriorVertex && !junctions.IsVoid(v))
      {
        sets.Unite(v, first);
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

/** Adds each void to the part with whose cells it has most junctions. */
void
AddVoids(const JunctionSet & junctions, TissueParts & parts)
{
  const std::vector<int>          partOfVertex = parts.PartOfVertex(junctions.NumberOfVertices());
  const std::size_t               numberOfCells = junctions.cells.size();
  std::vector<std::map<int, int>> numberOfJunctions(junctions.voids.size());
  for (const Junction & junction : junctions.junctions)
  {
    const VertexId last = junction.cells[3];
    const VertexId first = junction.cells[junction.cells[0] == ExteriorVertex ? 1 : 0];
    if (junctions.IsVoid(last) && !junctions.IsVoid(first))
    {
      ++numberOfJunctions[static_cast<std::size_t>(last) - numberOfCells][partOfVertex[first]];
    }
  }
  for (std::size_t i = 0; i < numberOfJunctions.size(); ++i)
  {
    const auto most = std::max_element(numberOfJunctions[i].begin(),
                                       numberOfJunctions[i].end(),
                                       [](const auto & a, const auto & b) { return a.second < b.second; });
    const int  part = most != numberOfJunctions[i].end() ? most->first : 0;
    parts.parts[static_cast<std::size_t>(part)].push_back(static_cast<VertexId>(numberOfCells + i));
  }
}

/** Returns the index of the part that holds the cell nearest to the given one. */
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

std::vector<int>
TissueParts::PartOfVertex(VertexId numberOfVertices) const
{
  std::vector<int> partOfVertex(static_cast<std::size_t>(numberOfVertices), -1);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (const VertexId v : parts[i])
    {
      partOfVertex[v] = static_cast<int>(i);
    }
  }
  return partOfVertex;
}

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
    return JoinTissueParts(junctions);
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
  AddVoids(junctions, result);
  return result;
}

TissueParts
JoinTissueParts(const JunctionSet & junctions)
{
  TissueParts result;
  result.parts.emplace_back();
  for (VertexId v = ExteriorVertex + 1; v < junctions.NumberOfVertices(); ++v)
  {
    result.parts.front().push_back(v);
  }
  return result;
}
} // namespace tissue
