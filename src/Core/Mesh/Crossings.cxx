/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Crossings.h"

#include "Geometry/BoxGrid.h"
#include "Geometry/TriangleCrossing.h"
#include "Mesh/HeightField.h"
#include "TissueTessellationCore/Geometry/Box.h"

#include <algorithm>
#include <optional>

namespace tissue
{
namespace
{
/** The first triangle of each run of triangles of one wall, and the number of all triangles. The runs are the walls
 * where the triangles are in the order of these. */
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

/** The box about the triangles first ... end - 1, or only about those of them that are marked. One must be. */
Box
BoxOfRun(const WallMesh & mesh, std::size_t first, std::size_t end, const std::vector<unsigned char> * isMarked)
{
  std::optional<Box> box;
  for (std::size_t t = first; t < end; ++t)
  {
    if (isMarked == nullptr || (*isMarked)[t] != 0)
    {
      const Triangle & triangle = mesh.triangles[t];
      box = box ? box : Box{ mesh.points[triangle[0]], mesh.points[triangle[0]] };
      std::for_each(triangle.begin(), triangle.end(), [&](PointId p) { Extend(*box, mesh.points[p]); });
    }
  }
  return *box;
}

/** Marks the runs whose boxes overlap that of the marked triangles of some run, and those with marked triangles. */
std::vector<unsigned char>
MarkNearRuns(const WallMesh & mesh, const std::vector<std::size_t> & first, const std::vector<unsigned char> & isMarked)
{
  const std::size_t numberOfRuns = first.size() - 1;
  const auto        place = [&](std::size_t run) { return isMarked.begin() + static_cast<std::ptrdiff_t>(first[run]); };
  std::vector<std::int32_t> runs;
  for (std::size_t run = 0; run < numberOfRuns; ++run)
  {
    if (std::find(place(run), place(run + 1), 1) != place(run + 1))
    {
      runs.push_back(static_cast<std::int32_t>(run));
    }
  }
  // Where most runs have marked triangles, hardly one is far from all of them.
  std::vector<unsigned char> isNear(numberOfRuns, 2 * runs.size() > numberOfRuns ? 1 : 0);
  if (runs.empty() || isNear.front() != 0)
  {
    return isNear;
  }
  // The boxes of the marked triangles follow those of the runs.
  std::vector<Box> boxes;
  for (std::size_t run = 0; run < numberOfRuns; ++run)
  {
    boxes.push_back(BoxOfRun(mesh, first[run], first[run + 1], nullptr));
  }
  for (const std::int32_t run : runs)
  {
    boxes.push_back(BoxOfRun(mesh, first[run], first[run + 1], &isMarked));
  }
  const BoxGrid grid(boxes);
  const auto    numberOfBoxes = static_cast<std::int32_t>(numberOfRuns);
  for (std::int64_t layer = 0; layer < grid.NumberOfLayers(); ++layer)
  {
    grid.VisitPairs(layer, [&](std::int32_t a, std::int32_t b) {
      if (a < numberOfBoxes && b >= numberOfBoxes)
      {
        isNear[a] = 1;
      }
    });
  }
  return isNear;
}

/** Some triangles' numbers and groups (BoxGrid). */
struct TriangleGroups
{
  std::vector<std::int32_t> numbers;
  std::vector<std::int32_t> groups;
};

/** Those of the runs that are near. The triangles of a run that is left out are a group, each other one is a group of
 * its own. */
TriangleGroups
CollectTriangles(const std::vector<std::size_t> & first, const std::vector<unsigned char> & isNear,
                 const std::vector<unsigned char> & isLeftOut)
{
  TriangleGroups result;
  for (std::size_t run = 0; run < isNear.size(); ++run)
  {
    for (std::size_t t = first[run]; isNear[run] != 0 && t < first[run + 1]; ++t)
    {
      result.numbers.push_back(static_cast<std::int32_t>(t));
      result.groups.push_back(static_cast<std::int32_t>(isLeftOut[run] != 0 ? first[run] : t));
    }
  }
  return result;
}

/** Finds the crossing pairs of which one triangle at least is marked, in ascending order. */
std::vector<TrianglePair>
FindCrossingsOfMarked(const WallMesh & mesh, const std::vector<unsigned char> & isMarked, const Execution & execution)
{
  const auto cross = [&](const TrianglePair & pair) {
    return TrianglesCross(mesh.points, mesh.triangles[pair[0]], mesh.triangles[pair[1]]);
  };
  std::vector<TrianglePair> crossings = SelectClosePairs(mesh, isMarked, false, cross, execution);
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}
} // namespace

std::vector<TrianglePair>
SelectClosePairs(const WallMesh & mesh, const std::vector<unsigned char> & isMarked, bool mayMeetWithin,
                 const TrianglePairTest & test, const Execution & execution)
{
  const std::vector<std::size_t>   first = FirstTrianglesOfRuns(mesh);
  const std::vector<unsigned char> isNear = MarkNearRuns(mesh, first, isMarked);
  const std::vector<unsigned char> isLeftOut =
    mayMeetWithin ? std::vector<unsigned char>(isNear.size(), 0) : MarkHeightFields(mesh, first, isNear, execution);
  TriangleGroups triangles = CollectTriangles(first, isNear, isLeftOut);
  if (triangles.numbers.empty())
  {
    return {};
  }
  // A grid finds the boxes that overlap, layer by layer in parallel; the layers' pairs are joined in order, so that the
  // result is the same for any number of threads.
  const auto    boxOf = [&](std::size_t i) { return BoxOfTriangle(mesh.points, mesh.triangles[triangles.numbers[i]]); };
  const BoxGrid grid(triangles.numbers.size(), boxOf, std::move(triangles.groups));
  std::vector<std::vector<TrianglePair>> found(grid.NumberOfLayers());
  execution.For(found.size(), [&](std::size_t layer) {
    grid.VisitPairs(static_cast<std::int64_t>(layer), [&](std::int32_t a, std::int32_t b) {
      const TrianglePair pair{ { triangles.numbers[a], triangles.numbers[b] } };
      if ((isMarked[pair[0]] != 0 || isMarked[pair[1]] != 0) && test(pair))
      {
        found[layer].push_back(pair);
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
