/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/SeparateWalls.h"

#include "Nerve/TissuePlaces.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace tissue
{
namespace
{
/** Pairs of cells, ascending, and the number of walls of each. */
struct WallCounts
{
  std::vector<VertexPair>  pairs;
  std::vector<std::size_t> numbersOfWalls;
};

WallCounts
FindPairsOfSeveralWalls(const LabelVolume & labels, const Execution & execution)
{
  WallCounts counts;
  const auto imageWalls = FindImageWalls(labels, execution);
  for (auto first = imageWalls.begin(); first != imageWalls.end();)
  {
    const auto last =
      std::find_if(first, imageWalls.end(), [&](const ImageWall & wall) { return wall.cells != first->cells; });
    const auto large =
      std::count_if(first, last, [](const ImageWall & wall) { return wall.numberOfFaces >= LeastFacesOfSeparateWall; });
    if (large > 1)
    {
      counts.pairs.push_back(first->cells);
      counts.numbersOfWalls.push_back(static_cast<std::size_t>(large));
    }
    first = last;
  }
  return counts;
}

/** An edge of a triangle of a pair of cells; the triangle is one of a list. */
struct PairEdge
{
  std::size_t                 pair;
  std::pair<PointId, PointId> points;
  std::int64_t                triangle;
};

/** Counts the pieces of the pairs' triangles in the mesh. */
std::vector<std::size_t>
CountPieces(const WallMesh & walls, const std::vector<VertexPair> & pairs)
{
  std::vector<std::size_t> pairOfTriangle;
  std::vector<PairEdge>    edges;
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    VertexPair cells = walls.walls[walls.wallOfTriangle[t]].cells;
    std::sort(cells.begin(), cells.end());
    const auto at = std::lower_bound(pairs.begin(), pairs.end(), cells);
    if (at == pairs.end() || *at != cells)
    {
      continue;
    }
    const auto pair = static_cast<std::size_t>(at - pairs.begin());
    for (int i = 0; i < 3; ++i)
    {
      edges.push_back({ pair,
                        std::minmax(PointId{ walls.triangles[t][i] }, PointId{ walls.triangles[t][(i + 1) % 3] }),
                        static_cast<std::int64_t>(pairOfTriangle.size()) });
    }
    pairOfTriangle.push_back(pair);
  }

  const auto keyOf = [](const PairEdge & edge) { return std::tie(edge.pair, edge.points); };
  std::sort(edges.begin(), edges.end(), [&](const PairEdge & a, const PairEdge & b) { return keyOf(a) < keyOf(b); });
  DisjointSets pieces(pairOfTriangle.size());
  for (std::size_t i = 1; i < edges.size(); ++i)
  {
    if (keyOf(edges[i]) == keyOf(edges[i - 1]))
    {
      pieces.Unite(edges[i].triangle, edges[i - 1].triangle);
    }
  }
  std::vector<std::size_t> numbersOfPieces(pairs.size(), 0);
  for (std::size_t t = 0; t < pairOfTriangle.size(); ++t)
  {
    const auto triangle = static_cast<std::int64_t>(t);
    numbersOfPieces[pairOfTriangle[t]] += pieces.Find(triangle) == triangle ? 1 : 0;
  }
  return numbersOfPieces;
}
} // namespace

SeparateWalls
CountSeparateWalls(const WallMesh & walls, const LabelVolume & labels, const Execution & execution)
{
  const WallCounts               inImage = FindPairsOfSeveralWalls(labels, execution);
  const std::vector<std::size_t> inMesh = CountPieces(walls, inImage.pairs);
  SeparateWalls                  result;
  result.numberOfPairs = inImage.pairs.size();
  for (std::size_t p = 0; p < inMesh.size(); ++p)
  {
    result.numberOfKeptPairs += inMesh[p] >= inImage.numbersOfWalls[p] ? 1 : 0;
  }
  return result;
}
} // namespace tissue
