/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/ImagePlaces.h"

#include "Image/BlockRow.h"

#include <algorithm>
#include <map>
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

/** \brief The faces at the upper sides of the voxels of a row, with those of the exterior in front of the image. */
template <typename TVertex>
class FaceRow
{
public:
  /** \param vertices those of the volume (VoxelVertices::Visit()).
   *  \param outside a row of exterior. */
  FaceRow(const LabelVolume & volume, const TVertex * vertices, const std::vector<TVertex> & outside, std::int32_t y,
          std::int32_t z)
    : m_Size(volume.size[0])
  {
    const auto rowOf = [&](std::int32_t rowY, std::int32_t rowZ) {
      const bool isInside = rowY >= 0 && rowZ >= 0 && rowY < volume.size[1] && rowZ < volume.size[2];
      return isInside ? vertices + (static_cast<std::size_t>(rowZ) * volume.size[1] + rowY) * volume.size[0]
                      : outside.data();
    };
    m_Row = rowOf(y, z);
    m_Next = { { nullptr, rowOf(y + 1, z), rowOf(y, z + 1) } };
  }

  /** Calls visit(x, axis, a, b) for each face between different vertices a and b, by x, then by the axis that it is
   * normal to. */
  template <typename TVisitor>
  void
  VisitDifferent(const TVisitor & visit) const
  {
    const auto visitIfDifferent = [&visit](std::int32_t x, int axis, VertexId a, VertexId b) {
      if (a != b)
      {
        visit(x, axis, a, b);
      }
    };
    visitIfDifferent(-1, 0, ExteriorVertex, m_Row[0]);
    constexpr std::int32_t stretch = 16; // most of which are of one cell
    for (std::int32_t begin = 0; begin < m_Size; begin += stretch)
    {
      const std::int32_t end = std::min(begin + stretch, m_Size);
      for (std::int32_t x = begin; !this->AreAlike(begin, end) && x < end; ++x)
      {
        visitIfDifferent(x, 0, m_Row[x], x + 1 < m_Size ? m_Row[x + 1] : ExteriorVertex);
        visitIfDifferent(x, 1, m_Row[x], m_Next[1][x]);
        visitIfDifferent(x, 2, m_Row[x], m_Next[2][x]);
      }
    }
  }

private:
  /** Whether the voxels of [begin, end) have no face between different vertices. */
  bool
  AreAlike(std::int32_t begin, std::int32_t end) const
  {
    VertexId differences = m_Row[begin] ^ (end < m_Size ? m_Row[end] : ExteriorVertex);
    for (std::int32_t x = begin; x < end; ++x)
    {
      differences |= (m_Row[begin] ^ m_Row[x]) | (m_Row[x] ^ m_Next[1][x]) | (m_Row[x] ^ m_Next[2][x]);
    }
    return differences == 0;
  }

  std::int32_t                   m_Size;
  const TVertex *                m_Row;
  std::array<const TVertex *, 3> m_Next;
};

/** Calls visit(x, y, z, axis, a, b) for all faces between different vertices, in raster order. */
template <typename TVisitor>
void
VisitFaces(const LabelVolume & volume, const TVisitor & visit)
{
  volume.vertices.Visit([&](const auto * vertices) {
    using Vertex = std::remove_cv_t<std::remove_reference_t<decltype(*vertices)>>;
    const std::vector<Vertex> outside(static_cast<std::size_t>(volume.size[0]), ExteriorVertex);
    for (std::int32_t z = -1; z < volume.size[2]; ++z)
    {
      for (std::int32_t y = -1; y < volume.size[1]; ++y)
      {
        FaceRow<Vertex>(volume, vertices, outside, y, z)
          .VisitDifferent([&](std::int32_t x, int axis, VertexId a, VertexId b) { visit(x, y, z, axis, a, b); });
      }
    }
  });
}

/** The four voxels of a block around its edge along each axis that is at the upper sides of the first voxel. */
constexpr int AroundEdge[3][4] = { { 0, 2, 4, 6 }, { 0, 1, 4, 5 }, { 0, 1, 2, 3 } };

/** The different cells around an edge, ascending; their number comes with them. */
std::pair<std::array<VertexId, 4>, int>
CellsAroundEdge(const BlockVoxels & voxels, int axis)
{
  std::array<VertexId, 4> around{};
  std::transform(
    std::begin(AroundEdge[axis]), std::end(AroundEdge[axis]), around.begin(), [&](int i) { return voxels[i]; });
  const auto [least, most] = std::minmax_element(around.begin(), around.end());
  const bool areThree = std::any_of(
    around.begin(), around.end(), [least = *least, most = *most](VertexId v) { return v != least && v != most; });
  if (!areThree)
  {
    return { around, *least == *most ? 1 : 2 };
  }
  std::sort(around.begin(), around.end());
  return { around, static_cast<int>(std::unique(around.begin(), around.end()) - around.begin()) };
}
} // namespace

void
ImagePlaces::Regroup(std::size_t                                                        numberOfNewGroups,
                     const std::function<std::vector<std::size_t>(std::size_t group)> & newGroupsOf)
{
  std::vector<Part> newGroups(numberOfNewGroups, Part{ 0, 0, 0 });
  for (std::size_t group = 0; group < m_Groups.size(); ++group)
  {
    const auto                     row = m_Rows[m_Groups[group].row];
    const std::vector<std::size_t> newGroupOf = newGroupsOf(group);
    if (newGroupOf.size() == 1)
    {
      newGroups[newGroupOf.front()] = m_Groups[group];
      continue;
    }
    std::map<std::size_t, std::vector<Place>> placesOf;
    for (std::size_t i = 0; i < newGroupOf.size(); ++i)
    {
      placesOf[newGroupOf[i]].push_back(row.begin()[m_Groups[group].begin + i]);
    }
    std::size_t at = m_Groups[group].begin;
    for (const auto & [newGroup, places] : placesOf)
    {
      std::copy(places.begin(), places.end(), row.begin() + at);
      newGroups[newGroup] = { m_Groups[group].row, at, at + places.size() };
      at += places.size();
    }
  }
  m_Groups = std::move(newGroups);
}

ImagePlaces
CollectImageFaces(const LabelVolume & volume, const std::vector<VertexPair> & pairs)
{
  std::unordered_map<std::uint64_t, std::size_t> groupOf;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    groupOf[KeyOf(pairs[i][0], pairs[i][1])] = i;
  }
  return ImagePlaces(pairs.size(), [&](const auto & add) {
    VisitFaces(volume, [&](std::int32_t x, std::int32_t y, std::int32_t z, int axis, VertexId a, VertexId b) {
      const auto at = groupOf.find(KeyOf(a, b));
      if (at != groupOf.end())
      {
        add(at->second,
            PlaceAt(volume, x + (axis == 0 ? 0.5 : 0.0), y + (axis == 1 ? 0.5 : 0.0), z + (axis == 2 ? 0.5 : 0.0)));
      }
    });
  });
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
  const auto addAround = [&](const BlockVoxels & voxels, int axis, double x, double y, double z) {
    const auto [around, count] = CellsAroundEdge(voxels, axis);
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
      add(cells, x + (axis == 0 ? 0.0 : 0.5), y + (axis == 1 ? 0.0 : 0.5), z + (axis == 2 ? 0.0 : 0.5));
    }
  };
  for (std::int32_t z = -1; z < volume.size[2]; ++z)
  {
    VisitMixedBlocks(volume, z, [&](std::int32_t x, std::int32_t y, const BlockVoxels & voxels) {
      for (int axis = 0; axis < 3; ++axis)
      {
        addAround(voxels, axis, x, y, z);
      }
    });
  }
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
