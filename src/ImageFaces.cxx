/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/ImageFaces.h"

#include <algorithm>
#include <unordered_map>

namespace tissue
{
namespace
{
struct Face
{
  WallId             wall;
  ImageFaces::Center center;
};

std::uint64_t
KeyOf(VertexId a, VertexId b)
{
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}
} // namespace

ImageFaces::ImageFaces(const LabelVolume & volume, const std::vector<WallMesh::Wall> & walls)
  : m_First(walls.size() + 1, 0)
{
  std::unordered_map<std::uint64_t, WallId> wallOf;
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    wallOf[KeyOf(walls[w].cells[0], walls[w].cells[1])] = static_cast<WallId>(w);
  }
  std::vector<Face> faces;
  std::uint64_t     recentKey = ~std::uint64_t{ 0 };
  WallId            recentWall = -1;
  const auto        add = [&](VertexId a, VertexId b, double x, double y, double z) {
    const std::uint64_t key = KeyOf(a, b);
    if (key != recentKey)
    {
      const auto at = wallOf.find(key);
      recentKey = key;
      recentWall = at != wallOf.end() ? at->second : -1;
    }
    if (recentWall >= 0)
    {
      const Point p = volume.ToPhysical({ { x, y, z } });
      faces.push_back(
        { recentWall, { { static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2]) } } });
    }
  };
  for (std::int32_t z = -1; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = -1; y < volume.size[1]; ++y)
    {
      for (std::int32_t x = -1; x < volume.size[0]; ++x)
      {
        const VertexId here = volume.At(x, y, z);
        const VertexId right = volume.At(x + 1, y, z);
        const VertexId below = volume.At(x, y + 1, z);
        const VertexId behind = volume.At(x, y, z + 1);
        if (here != right)
        {
          add(here, right, x + 0.5, y, z);
        }
        if (here != below)
        {
          add(here, below, x, y + 0.5, z);
        }
        if (here != behind)
        {
          add(here, behind, x, y, z + 0.5);
        }
      }
    }
  }
  for (const Face & face : faces)
  {
    ++m_First[face.wall + 1];
  }
  for (std::size_t w = 1; w < m_First.size(); ++w)
  {
    m_First[w] += m_First[w - 1];
  }
  m_Centers.resize(faces.size());
  std::vector<std::size_t> next(m_First.begin(), m_First.end() - 1);
  for (const Face & face : faces)
  {
    m_Centers[next[face.wall]++] = face.center;
  }
}
} // namespace tissue
