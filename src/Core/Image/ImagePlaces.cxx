/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/ImagePlaces.h"

#include <algorithm>
#include <unordered_map>

namespace tissue
{
namespace
{
std::uint64_t
KeyOf(VertexId a, VertexId b)
{
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}

ImagePlaces::Place
PlaceAt(const LabelVolume & volume, double x, double y, double z)
{
  const Point p = volume.ToPhysical({ { x, y, z } });
  return { { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) } };
}

/** Calls visit(x, y, z) for the first voxel of each block of eight that is not all of one cell; from -1, so that the
 * outside is seen. */
template <typename TVisitor>
void
VisitMixedBlocks(const LabelVolume & volume, const TVisitor & visit)
{
  for (std::int32_t z = -1; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = -1; y < volume.size[1]; ++y)
    {
      // The four voxels of a block at the same x, and those before.
      std::array<VertexId, 4> before{};
      for (std::int32_t x = -2; x < volume.size[0]; ++x)
      {
        const std::array<VertexId, 4> next{ { volume.At(x + 1, y, z),
                                              volume.At(x + 1, y + 1, z),
                                              volume.At(x + 1, y, z + 1),
                                              volume.At(x + 1, y + 1, z + 1) } };
        const bool isMixed = next[0] != next[1] || next[0] != next[2] || next[0] != next[3] || next != before;
        if (x >= -1 && isMixed)
        {
          visit(x, y, z);
        }
        before = next;
      }
    }
  }
}
} // namespace

ImagePlaces::ImagePlaces(std::size_t numberOfGroups, const Entries & entries)
  : m_Places(numberOfGroups, [&entries](const auto & add) {
    for (const Entry & entry : entries)
    {
      add(static_cast<std::size_t>(entry.group), entry.place);
    }
  })
{}

ImagePlaces
CollectImageFaces(const LabelVolume & volume, const std::vector<VertexPair> & pairs)
{
  std::unordered_map<std::uint64_t, std::int32_t> groupOf;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    groupOf[KeyOf(pairs[i][0], pairs[i][1])] = static_cast<std::int32_t>(i);
  }
  ImagePlaces::Entries entries;
  VisitMixedBlocks(volume, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    const VertexId here = volume.At(x, y, z);
    const VertexId next[3] = { volume.At(x + 1, y, z), volume.At(x, y + 1, z), volume.At(x, y, z + 1) };
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto at = here != next[axis] ? groupOf.find(KeyOf(here, next[axis])) : groupOf.end();
      if (at != groupOf.end())
      {
        entries.push_back(
          { at->second,
            PlaceAt(volume, x + (axis == 0 ? 0.5 : 0.0), y + (axis == 1 ? 0.5 : 0.0), z + (axis == 2 ? 0.5 : 0.0)) });
      }
    }
  });
  return ImagePlaces(pairs.size(), entries);
}

ImagePlaces
CollectImageLines(const LabelVolume & volume, const std::vector<VertexTriple> & lines)
{
  ImagePlaces::Entries entries;
  const auto           add = [&](const VertexTriple & cells, double x, double y, double z) {
    const auto at = std::lower_bound(lines.begin(), lines.end(), cells);
    if (at != lines.end() && *at == cells)
    {
      entries.push_back({ static_cast<std::int32_t>(at - lines.begin()), PlaceAt(volume, x, y, z) });
    }
  };
  VisitMixedBlocks(volume, [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int i = axis == 0 ? 0 : 1;
      const int j = axis == 1 ? 0 : 1;
      const int k = axis == 2 ? 0 : 1;
      // The voxels around an edge along the axis.
      const bool              isAlongX = axis == 0;
      const bool              isAlongZ = axis == 2;
      std::array<VertexId, 4> around{ { volume.At(x, y, z),
                                        isAlongX ? volume.At(x, y + 1, z) : volume.At(x + 1, y, z),
                                        isAlongZ ? volume.At(x, y + 1, z) : volume.At(x, y, z + 1),
                                        volume.At(x + i, y + j, z + k) } };
      std::sort(around.begin(), around.end());
      const auto count = std::unique(around.begin(), around.end()) - around.begin();
      for (int left = 0; count >= 3 && left < (count == 4 ? 4 : 1); ++left)
      {
        VertexTriple cells{};
        for (int c = 0, n = 0; n < 3; ++c)
        {
          if (count == 3 || c != left)
          {
            cells[n++] = around[c];
          }
        }
        add(cells, x + 0.5 * i, y + 0.5 * j, z + 0.5 * k);
      }
    }
  });
  return ImagePlaces(lines.size(), entries);
}

AreaAndDistance
IntegrateDistance(const std::vector<Point> & points, const std::vector<Triangle> & triangles, std::size_t firstTriangle,
                  std::size_t endTriangle, const PlaceTree & places)
{
  AreaAndDistance sums;
  for (std::size_t t = firstTriangle; t < endTriangle; ++t)
  {
    const Point & a = points[triangles[t][0]];
    const Point & b = points[triangles[t][1]];
    const Point & c = points[triangles[t][2]];
    const double  area = TriangleArea(a, b, c);
    sums.area += area;
    sums.distance += area * places.DistanceToNearest((1.0 / 3.0) * (a + b + c));
  }
  return sums;
}
} // namespace tissue
