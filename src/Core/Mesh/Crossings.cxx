/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Crossings.h"

#include "Common/Algorithms.h"
#include "Geometry/BoxGrid.h"
#include "Geometry/TriangleCrossing.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Finds the crossing pairs of which one triangle at least is marked, in ascending order. */
std::vector<TrianglePair>
FindCrossingsOfMarked(const WallMesh & mesh, const std::vector<unsigned char> & isMarked, const Execution & execution)
{
  const auto                close = CollectClosePairs(mesh, mesh.points, mesh.points, isMarked, execution);
  std::vector<TrianglePair> crossings;
  const auto                test = [&](std::size_t i) {
    return TrianglesCross(mesh.points, mesh.triangles[close[i][0]], mesh.triangles[close[i][1]]);
  };
  for (const std::size_t i : Select(close.size(), test, execution))
  {
    crossings.push_back(close[i]);
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/** Marks the given walls, of which there must be one at least, and those whose boxes overlap theirs. */
std::vector<unsigned char>
MarkNearWalls(const WallMesh & mesh, const std::vector<unsigned char> & isGiven)
{
  std::vector<Box>           boxes(mesh.walls.size());
  std::vector<unsigned char> hasBox(mesh.walls.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const WallId wall = mesh.wallOfTriangle[t];
    const Box    box = BoxOfTriangle(mesh.points, mesh.triangles[t]);
    if (hasBox[wall] == 0)
    {
      hasBox[wall] = 1;
      boxes[wall] = box;
    }
    Extend(boxes[wall], box.lower);
    Extend(boxes[wall], box.upper);
  }
  std::vector<unsigned char> isNear = isGiven;
  const BoxGrid              grid(boxes);
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      isNear[a] |= isGiven[b];
      isNear[b] |= isGiven[a];
    });
  }
  return isNear;
}
} // namespace

std::vector<TrianglePair>
CollectClosePairs(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there,
                  const std::vector<unsigned char> & isMarked, const Execution & execution)
{
  // The box of a triangle holds its points at both places. A grid finds the boxes that overlap, layer by layer in
  // parallel; the layers' pairs are joined in order, so that the result is the same for any number of threads.
  if (mesh.triangles.empty())
  {
    return {};
  }
  std::vector<Box> boxes(mesh.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    boxes[t] = BoxOfTriangle(here, triangle);
    for (const PointId p : triangle)
    {
      Extend(boxes[t], there[p]);
    }
  }
  const BoxGrid                          grid(boxes);
  std::vector<std::vector<TrianglePair>> found(grid.NumberOfLayers());
  execution.For(found.size(), [&](std::size_t layer) {
    grid.VisitPairs(static_cast<std::int64_t>(layer), [&](std::int32_t a, std::int32_t b) {
      if (isMarked[a] != 0 || isMarked[b] != 0)
      {
        found[layer].push_back({ { a, b } });
      }
    });
  });
  std::vector<TrianglePair> pairs;
  for (const auto & part : found)
  {
    pairs.insert(pairs.end(), part.begin(), part.end());
  }
  return pairs;
}

std::vector<TrianglePair>
FindCrossings(const WallMesh & mesh, const Execution & execution)
{
  return FindCrossingsOfMarked(mesh, std::vector<unsigned char>(mesh.triangles.size(), 1), execution);
}

std::vector<TrianglePair>
FindCrossingsOfWalls(const WallMesh & mesh, const std::vector<WallId> & walls, const Execution & execution)
{
  if (walls.empty())
  {
    return {};
  }
  std::vector<unsigned char> isOf(mesh.walls.size(), 0);
  for (const WallId wall : walls)
  {
    isOf[wall] = 1;
  }
  // The given walls are few, so only triangles of walls near them are tested. They are copied to a mesh of their own,
  // and the pairs found there get their triangles' numbers in the whole mesh back.
  const std::vector<unsigned char> isNear = MarkNearWalls(mesh, isOf);
  WallMesh                         near;
  std::vector<unsigned char>       isMarked;
  std::vector<std::int32_t>        numbers;
  near.points = mesh.points;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (isNear[mesh.wallOfTriangle[t]] != 0)
    {
      near.triangles.push_back(mesh.triangles[t]);
      isMarked.push_back(isOf[mesh.wallOfTriangle[t]]);
      numbers.push_back(static_cast<std::int32_t>(t));
    }
  }
  std::vector<TrianglePair> crossings = FindCrossingsOfMarked(near, isMarked, execution);
  for (TrianglePair & pair : crossings)
  {
    pair = { { numbers[pair[0]], numbers[pair[1]] } };
  }
  return crossings;
}
} // namespace tissue
