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
#include "Mesh/HeightField.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** Finds the crossing pairs of which one triangle at least is marked, in ascending order. */
std::vector<TrianglePair>
FindCrossingsOfMarked(const WallMesh & mesh, const std::vector<unsigned char> & isMarked, const Execution & execution)
{
  const ClosePairs          close(mesh, mesh.points, mesh.points, isMarked);
  const auto                isLeftOut = MarkHeightFields(mesh, close.FirstOfRuns(), close.NearRuns(), execution);
  const auto                pairs = close.Collect(isLeftOut, execution);
  std::vector<TrianglePair> crossings;
  const auto                test = [&](std::size_t i) {
    return TrianglesCross(mesh.points, mesh.triangles[pairs[i][0]], mesh.triangles[pairs[i][1]]);
  };
  for (const std::size_t i : Select(pairs.size(), test, execution))
  {
    crossings.push_back(pairs[i]);
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}
} // namespace

std::vector<std::size_t>
FirstTrianglesOfRuns(const WallMesh & mesh)
{
  std::vector<std::size_t> first;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (t == 0 || mesh.wallOfTriangle[t] != mesh.wallOfTriangle[t - 1])
    {
      first.push_back(t);
    }
  }
  first.push_back(mesh.triangles.size());
  return first;
}

ClosePairs::ClosePairs(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there,
                       const std::vector<unsigned char> & isMarked)
  : m_First(FirstTrianglesOfRuns(mesh))
  , m_Boxes(mesh.triangles.size())
  , m_IsMarked(isMarked)
{
  for (std::size_t t = 0; t < m_Boxes.size(); ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    m_Boxes[t] = BoxOfTriangle(here, triangle);
    for (const PointId p : triangle)
    {
      Extend(m_Boxes[t], there[p]);
    }
  }
  this->FindNearRuns();
}

void
ClosePairs::FindNearRuns()
{
  const std::size_t          numberOfRuns = m_First.size() - 1;
  const auto                 isMarked = m_IsMarked.begin();
  const auto                 place = [this](std::size_t run) { return static_cast<std::ptrdiff_t>(m_First[run]); };
  std::vector<unsigned char> hasMarked;
  for (std::size_t run = 0; run < numberOfRuns; ++run)
  {
    const auto end = isMarked + place(run + 1);
    hasMarked.push_back(std::find(isMarked + place(run), end, 1) != end ? 1 : 0);
  }
  const auto count = static_cast<std::size_t>(std::count(hasMarked.begin(), hasMarked.end(), 1));
  m_IsNear = hasMarked;
  // Where most runs have marked triangles, hardly one is far from all of them.
  if (count == 0 || 2 * count > numberOfRuns)
  {
    std::fill(m_IsNear.begin(), m_IsNear.end(), count > 0 ? 1 : 0);
    return;
  }
  std::vector<Box> boxes;
  for (std::size_t run = 0; run < numberOfRuns; ++run)
  {
    boxes.push_back(m_Boxes[m_First[run]]);
    for (std::size_t t = m_First[run]; t < m_First[run + 1]; ++t)
    {
      Extend(boxes[run], m_Boxes[t].lower);
      Extend(boxes[run], m_Boxes[t].upper);
    }
  }
  const BoxGrid grid(boxes);
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      m_IsNear[a] |= hasMarked[b];
      m_IsNear[b] |= hasMarked[a];
    });
  }
}

std::vector<TrianglePair>
ClosePairs::Collect(const std::vector<unsigned char> & isLeftOut, const Execution & execution) const
{
  // A grid finds the boxes that overlap, layer by layer in parallel; the layers' pairs are joined in order, so that the
  // result is the same for any number of threads. The triangles of a run that is left out are a group in it, each other
  // one is a group of its own.
  std::vector<Box>          boxes;
  std::vector<std::int32_t> numbers;
  std::vector<std::int32_t> groups;
  for (std::size_t run = 0; run < m_IsNear.size(); ++run)
  {
    for (std::size_t t = m_First[run]; m_IsNear[run] != 0 && t < m_First[run + 1]; ++t)
    {
      boxes.push_back(m_Boxes[t]);
      numbers.push_back(static_cast<std::int32_t>(t));
      groups.push_back(static_cast<std::int32_t>(isLeftOut[run] != 0 ? m_First[run] : t));
    }
  }
  if (boxes.empty())
  {
    return {};
  }
  const BoxGrid                          grid(boxes, std::move(groups));
  std::vector<std::vector<TrianglePair>> found(grid.NumberOfLayers());
  execution.For(found.size(), [&](std::size_t layer) {
    grid.VisitPairs(static_cast<std::int64_t>(layer), [&](std::int32_t a, std::int32_t b) {
      if (m_IsMarked[numbers[a]] != 0 || m_IsMarked[numbers[b]] != 0)
      {
        found[layer].push_back({ { numbers[a], numbers[b] } });
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

void
ClosePairs::AppendWithin(std::size_t run, std::vector<TrianglePair> & pairs) const
{
  const std::vector<Box> boxes(m_Boxes.begin() + static_cast<std::ptrdiff_t>(m_First[run]),
                               m_Boxes.begin() + static_cast<std::ptrdiff_t>(m_First[run + 1]));
  const BoxGrid          grid(boxes);
  const auto             first = static_cast<std::int32_t>(m_First[run]);
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      if (m_IsMarked[first + a] != 0 || m_IsMarked[first + b] != 0)
      {
        pairs.push_back({ { first + a, first + b } });
      }
    });
  }
}

std::vector<TrianglePair>
FindCrossings(const WallMesh & mesh, const Execution & execution)
{
  return FindCrossingsOfMarked(mesh, std::vector<unsigned char>(mesh.triangles.size(), 1), execution);
}

std::vector<TrianglePair>
FindCrossingsOfWalls(const WallMesh & mesh, const std::vector<WallId> & walls, const Execution & execution)
{
  std::vector<unsigned char> isGiven(mesh.walls.size(), 0);
  for (const WallId wall : walls)
  {
    isGiven[wall] = 1;
  }
  std::vector<unsigned char> isMarked;
  for (const WallId wall : mesh.wallOfTriangle)
  {
    isMarked.push_back(isGiven[wall]);
  }
  return FindCrossingsOfMarked(mesh, isMarked, execution);
}
} // namespace tissue
