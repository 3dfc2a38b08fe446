/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef VoxelTissue_h
#define VoxelTissue_h

#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Image/BlockScan.h"
#include "TissueTessellationCore/Image/GatherJunctions.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <algorithm>
#include <functional>
#include <map>
#include <vector>

/** Label images made in code, and what the core gathers from them. */
namespace tissue_test
{
using namespace tissue;

/** A label image: its size and the label of voxel (x, y, z), counted from 0. */
struct VoxelImage
{
  using LabelFunction = std::function<Label(int x, int y, int z)>;

  BlockScan::Index size;
  LabelFunction    labelAt;
  ExteriorLabels   exterior{ true, 0, false };
};

/** Four cells around the line x = y = 4, labels 10, 20, 30 and 40 of 2 x 2 x 4 voxels each, in a margin of two voxels
 * of label 0. */
inline VoxelImage
FourColumns()
{
  return { { { 8, 8, 8 } }, [](int x, int y, int z) {
            const bool isInside = x >= 2 && x < 6 && y >= 2 && y < 6 && z >= 2 && z < 6;
            return Label{ isInside ? 10 + 10 * (x >= 4) + 20 * (y >= 4) : 0 };
          } };
}

/** Labels 0 ... count - 1 drawn at random, voxel by voxel. */
inline VoxelImage
Noise(const BlockScan::Index & size, int count)
{
  Random             random(1);
  std::vector<Label> labels(static_cast<std::size_t>(size[0]) * size[1] * size[2]);
  for (Label & label : labels)
  {
    label = static_cast<Label>(random.Index(count));
  }
  return { size, [size, labels](int x, int y, int z) { return labels[(z * size[1] + y) * size[0] + x]; } };
}

/** Feeds one plane, by its padded coordinate, in runs that are as long as can be. */
inline void
FeedPlane(const VoxelImage & image, std::int32_t plane, BlockScan & scan)
{
  scan.BeginPlane();
  for (std::int32_t y = 0; y < image.size[1] + 2; ++y)
  {
    const bool isInImage = plane >= 1 && plane <= image.size[2] && y >= 1 && y <= image.size[1];
    for (std::int32_t x = 1; isInImage && x <= image.size[0]; ++x)
    {
      const Label label = image.labelAt(x - 1, y - 1, plane - 1);
      if (x == image.size[0] || image.labelAt(x, y - 1, plane - 1) != label)
      {
        scan.AddRun(label, x + 1);
      }
    }
    scan.EndRow();
  }
}

/** A scan that counts the planes from `first` to the one before `end`, in padded coordinates. */
inline BlockScan
ScanPlanes(const VoxelImage & image, std::int32_t first, std::int32_t end)
{
  BlockScan scan(image.size, first, image.exterior);
  for (std::int32_t plane = first - 1; plane < end; ++plane)
  {
    FeedPlane(image, plane, scan);
  }
  return scan;
}

/** The junctions by one scan for each of the first planes given. */
inline JunctionSet
JunctionsOf(const VoxelImage & image, const Point & spacing = { { 1, 1, 1 } },
            const std::vector<std::int32_t> & firstPlanes = { 1 })
{
  std::vector<BlockScan> scans;
  for (std::size_t i = 0; i < firstPlanes.size(); ++i)
  {
    scans.push_back(ScanPlanes(
      image, firstPlanes[i], i + 1 < firstPlanes.size() ? firstPlanes[i + 1] : static_cast<int>(image.size[2]) + 2));
  }
  std::vector<const BlockScan *> pointers;
  for (const BlockScan & scan : scans)
  {
    pointers.push_back(&scan);
  }
  return GatherJunctions(pointers, image.size, spacing, image.exterior);
}

/** The junctions of a volume whose vertices are numbered without gaps, in physical space; the label of a cell is its
 * vertex. The steps must be orthogonal. */
inline JunctionSet
JunctionsOf(const LabelVolume & volume)
{
  const VoxelImage image{ volume.size, [&volume](int x, int y, int z) { return Label{ volume.At(x, y, z) }; } };
  JunctionSet set = JunctionsOf(image, { { Norm(volume.steps[0]), Norm(volume.steps[1]), Norm(volume.steps[2]) } });
  for (Cell & cell : set.cells)
  {
    cell.center = volume.ToPhysical(cell.center);
  }
  for (Wall & wall : set.walls)
  {
    wall.center = volume.ToPhysical(wall.center);
  }
  for (Junction & junction : set.junctions)
  {
    junction.position = volume.ToPhysical(junction.position);
  }
  set.grid = { volume.size, volume.origin, volume.steps };
  return set;
}

/** A ball of about 25 cells in a cube of `side` voxels: the cells of the nearest of 27 points near a lattice, where
 * they have a voxel. With a hollow in its middle, which is exterior, the ball is a shell. */
inline LabelVolume
VoronoiBall(int side, double hollowRadius = 0.0)
{
  Random             random(2);
  std::vector<Point> seeds;
  const double       step = (side - 4.0) / 3.0;
  for (int i = 0; i < 27; ++i)
  {
    Point seed{ { 2.0 + step * (i % 3), 2.0 + step * (i / 3 % 3), 2.0 + step * (i / 9) } };
    for (double & coordinate : seed)
    {
      coordinate += step * (0.3 + 0.4 * random.Uniform()) - 0.5;
    }
    seeds.push_back(seed);
  }
  LabelVolume volume;
  volume.size = { { side, side, side } };
  volume.vertices = VoxelVertices(static_cast<std::size_t>(side) * side * side, ExteriorVertex);
  const double            middle = 0.5 * (side - 1);
  std::map<int, VertexId> vertexOf;
  const auto              visit = [&](const auto & take) {
    for (std::size_t i = 0; i < volume.vertices.size(); ++i)
    {
      const auto   at = static_cast<int>(i);
      const Point  p{ { double(at % side), double(at / side % side), double(at / side / side) } };
      const double radius = Distance(p, { { middle, middle, middle } });
      const auto   nearest = std::min_element(
        seeds.begin(), seeds.end(), [&p](const Point & a, const Point & b) { return Distance(a, p) < Distance(b, p); });
      if (radius < middle - 1.0 && radius >= hollowRadius)
      {
        take(i, static_cast<int>(nearest - seeds.begin()));
      }
    }
  };
  visit([&](std::size_t, int place) { vertexOf[place] = 0; });
  VertexId last = ExteriorVertex;
  for (auto & entry : vertexOf)
  {
    entry.second = ++last;
  }
  visit([&](std::size_t i, int place) { volume.vertices.Put(i, vertexOf[place]); });
  return volume;
}
} // namespace tissue_test

#endif
