/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/TissuePlaces.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
using FaceId = std::int32_t;
constexpr FaceId None = -1;

/** Faces found to be of one wall so far: the sums are of twice the coordinates of their centres, so whole. */
struct Part
{
  VertexPair                  cells;
  std::int64_t                numberOfFaces = 0;
  std::array<std::int64_t, 3> sum = { { 0, 0, 0 } };
};

/** A plane of voxels with a border of one voxel of exterior. */
struct LabelPlane
{
  std::int32_t          width;
  std::int32_t          height;
  std::vector<VertexId> labels;
};

LabelPlane
ReadPlane(const LabelVolume & volume, std::int32_t z)
{
  LabelPlane plane{ volume.size[0] + 2, volume.size[1] + 2, {} };
  plane.labels.assign(static_cast<std::size_t>(plane.width) * plane.height, ExteriorVertex);
  for (std::int32_t y = 0; z >= 0 && z < volume.size[2] && y < volume.size[1]; ++y)
  {
    const auto row = volume.vertices.begin() + (static_cast<std::ptrdiff_t>(z) * volume.size[1] + y) * volume.size[0];
    std::copy(row, row + volume.size[0], plane.labels.begin() + (y + 1) * static_cast<std::ptrdiff_t>(plane.width) + 1);
  }
  return plane;
}

/** The part that each face at the upper side of a voxel of a plane belongs to, by axis. */
using PlaneFaces = std::array<std::vector<FaceId>, 3>;

/** \brief Finds the walls within a slab of planes, and keeps the faces of its first and of its last plane: there the
 * next slabs go on. */
class WallScan
{
public:
  WallScan(const LabelVolume & volume, std::int32_t begin, std::int32_t end)
    : m_Plane(ReadPlane(volume, begin))
  {
    const std::size_t size = m_Plane.labels.size();
    for (std::int32_t z = begin; z < end; ++z)
    {
      const LabelPlane next = ReadPlane(volume, z + 1);
      PlaneFaces       below = std::move(m_Last);
      m_Last = {
        { std::vector<FaceId>(size, None), std::vector<FaceId>(size, None), std::vector<FaceId>(size, None) }
      };
      this->FindFaces(next, below, z);
      this->JoinWithin();
      if (z == begin)
      {
        m_First = m_Last;
      }
      else
      {
        JoinAcross(m_Plane.width, below, m_Last, m_Parts, m_Parts, 0, 0, m_Sets);
      }
      m_Plane = next;
    }
  }

  /** Joins the faces around the voxel edges between two planes of faces, the upper one of which may be of the next
   * slab. */
  static void
  JoinAcross(std::int32_t width, const PlaneFaces & lower, const PlaneFaces & upper,
             const std::vector<Part> & lowerParts, const std::vector<Part> & upperParts, FaceId lowerOffset,
             FaceId upperOffset, DisjointSets & sets)
  {
    const auto join = [&](FaceId sideBelow, FaceId sideAbove, FaceId flatNear, FaceId flatFar) {
      const auto cells = [&](int i, FaceId face) { return i == 1 ? upperParts[face].cells : lowerParts[face].cells; };
      JoinAround(
        { { sideBelow, sideAbove, flatNear, flatFar } },
        cells,
        [&](int i, FaceId face) { return face + (i == 1 ? upperOffset : lowerOffset); },
        sets);
    };
    for (std::size_t p = 0; p + static_cast<std::size_t>(width) < lower[0].size(); ++p)
    {
      join(lower[0][p], upper[0][p], lower[2][p], lower[2][p + 1]);
      join(lower[1][p], upper[1][p], lower[2][p], lower[2][p + static_cast<std::size_t>(width)]);
    }
  }

  const std::vector<Part> &
  GetParts() const
  {
    return m_Parts;
  }
  DisjointSets &
  GetSets()
  {
    return m_Sets;
  }
  const PlaneFaces &
  GetFirst() const
  {
    return m_First;
  }
  const PlaneFaces &
  GetLast() const
  {
    return m_Last;
  }

private:
  /** Of the four faces around a voxel edge, those between the same two cells are of one wall. */
  template <typename TCells, typename TIndex>
  static void
  JoinAround(const std::array<FaceId, 4> & faces, const TCells & cells, const TIndex & index, DisjointSets & sets)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; faces[i] != None && j < 4; ++j)
      {
        if (faces[j] != None && index(i, faces[i]) != index(j, faces[j]) && cells(i, faces[i]) == cells(j, faces[j]))
        {
          sets.Unite(index(i, faces[i]), index(j, faces[j]));
        }
      }
    }
  }

  /** The part of a face, that of the first face around it that is of the same cells: most faces need no new part. */
  template <std::size_t VCount>
  FaceId
  AddFace(VertexId a, VertexId b, const std::array<FaceId, VCount> & around, std::array<std::int64_t, 3> center)
  {
    const VertexPair cells{ { std::min(a, b), std::max(a, b) } };
    const auto       found = std::find_if(
      around.begin(), around.end(), [&](FaceId face) { return face != None && m_Parts[face].cells == cells; });
    const FaceId face = found != around.end() ? *found : static_cast<FaceId>(m_Sets.Add());
    if (found == around.end())
    {
      m_Parts.push_back({ cells, 0, { { 0, 0, 0 } } });
    }
    ++m_Parts[face].numberOfFaces;
    for (int axis = 0; axis < 3; ++axis)
    {
      m_Parts[face].sum[axis] += center[axis];
    }
    return face;
  }

  void
  FindFaces(const LabelPlane & next, const PlaneFaces & below, std::int32_t z)
  {
    const std::size_t width = static_cast<std::size_t>(m_Plane.width);
    const auto &      labels = m_Plane.labels;
    const auto        under = [&](int axis, std::size_t p) { return below[axis].empty() ? None : below[axis][p]; };
    for (std::int32_t y = 0; y + 1 < m_Plane.height; ++y)
    {
      for (std::int32_t x = 0; x + 1 < m_Plane.width; ++x)
      {
        const std::size_t                 p = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        const std::array<std::int64_t, 3> twice{ { 2 * (x - 1), 2 * (y - 1), 2 * z } };
        const VertexId                    label = labels[p];
        // What is behind a voxel exists for all but the first of a row or plane, where faces do not occur.
        if (labels[p + 1] != label)
        {
          m_Last[0][p] = this->AddFace<6>(label,
                                          labels[p + 1],
                                          { { m_Last[0][p - width],
                                              m_Last[1][p - width],
                                              m_Last[1][p - width + 1],
                                              under(0, p),
                                              under(2, p),
                                              under(2, p + 1) } },
                                          { { twice[0] + 1, twice[1], twice[2] } });
        }
        if (labels[p + width] != label)
        {
          m_Last[1][p] = this->AddFace<6>(
            label,
            labels[p + width],
            { { m_Last[1][p - 1], m_Last[0][p - 1], m_Last[0][p], under(1, p), under(2, p), under(2, p + width) } },
            { { twice[0], twice[1] + 1, twice[2] } });
        }
        if (next.labels[p] != label)
        {
          m_Last[2][p] = this->AddFace<6>(label,
                                          next.labels[p],
                                          { { m_Last[2][p - 1],
                                              m_Last[2][p - width],
                                              m_Last[0][p],
                                              m_Last[1][p],
                                              m_Last[0][p - 1],
                                              m_Last[1][p - width] } },
                                          { { twice[0], twice[1], twice[2] + 1 } });
        }
      }
    }
  }

  /** Joins the faces around the voxel edges that stand on the plane. */
  void
  JoinWithin()
  {
    const std::size_t width = static_cast<std::size_t>(m_Plane.width);
    const auto        cells = [&](int, FaceId face) { return m_Parts[face].cells; };
    for (std::size_t p = 0; p + width < m_Last[0].size(); ++p)
    {
      JoinAround(
        { { m_Last[0][p], m_Last[0][p + width], m_Last[1][p], m_Last[1][p + 1] } },
        cells,
        [](int, FaceId face) { return face; },
        m_Sets);
      JoinAround(
        { { m_Last[0][p], m_Last[2][p], m_Last[2][p + 1], None } },
        cells,
        [](int, FaceId face) { return face; },
        m_Sets);
      JoinAround(
        { { m_Last[1][p], m_Last[2][p], m_Last[2][p + width], None } },
        cells,
        [](int, FaceId face) { return face; },
        m_Sets);
    }
  }

  LabelPlane        m_Plane;
  PlaneFaces        m_First;
  PlaneFaces        m_Last;
  std::vector<Part> m_Parts;
  DisjointSets      m_Sets;
};

/** The walls of parts that have been joined to sets. */
std::vector<ImageWall>
GatherWalls(const LabelVolume & volume, const std::vector<Part> & parts, DisjointSets & sets)
{
  std::vector<Part> joined(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    Part & whole = joined[static_cast<std::size_t>(sets.Find(static_cast<std::int64_t>(i)))];
    whole.cells = parts[i].cells;
    whole.numberOfFaces += parts[i].numberOfFaces;
    std::transform(whole.sum.begin(), whole.sum.end(), parts[i].sum.begin(), whole.sum.begin(), std::plus<>());
  }
  std::vector<ImageWall> walls;
  for (const Part & part : joined)
  {
    if (part.numberOfFaces > 0)
    {
      const double half = 0.5 / static_cast<double>(part.numberOfFaces);
      walls.push_back({ part.cells,
                        part.numberOfFaces,
                        volume.ToPhysical({ { half * static_cast<double>(part.sum[0]),
                                              half * static_cast<double>(part.sum[1]),
                                              half * static_cast<double>(part.sum[2]) } }) });
    }
  }
  std::stable_sort(walls.begin(), walls.end(), [](const ImageWall & a, const ImageWall & b) {
    return a.cells != b.cells ? a.cells < b.cells : a.numberOfFaces > b.numberOfFaces;
  });
  return walls;
}
} // namespace

std::vector<ImageWall>
FindImageWalls(const LabelVolume & volume, const Execution & execution)
{
  // Planes of a slab: few slabs, as each keeps two planes of faces, and yet one for each of many threads.
  constexpr std::int32_t             planesPerSlab = 32;
  const std::int32_t                 planes = volume.size[2] + 1;
  const auto                         count = static_cast<std::size_t>((planes + planesPerSlab - 1) / planesPerSlab);
  std::vector<std::vector<WallScan>> scans(count); // each of one: a scan is made where it is run
  execution.For(count, [&](std::size_t i) {
    const auto begin = static_cast<std::int32_t>(i) * planesPerSlab - 1;
    scans[i].emplace_back(volume, begin, std::min(begin + planesPerSlab, volume.size[2]));
  });
  std::vector<Part> parts;
  DisjointSets      sets;
  FaceId            lowerOffset = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    WallScan &   scan = scans[i].front();
    const FaceId offset = static_cast<FaceId>(parts.size());
    parts.insert(parts.end(), scan.GetParts().begin(), scan.GetParts().end());
    for (std::size_t k = 0; k < scan.GetParts().size(); ++k)
    {
      sets.Add();
      sets.Unite(offset + static_cast<FaceId>(k), offset + scan.GetSets().Find(static_cast<std::int64_t>(k)));
    }
    if (i > 0)
    {
      const WallScan & before = scans[i - 1].front();
      WallScan::JoinAcross(volume.size[0] + 2,
                           before.GetLast(),
                           scan.GetFirst(),
                           before.GetParts(),
                           scan.GetParts(),
                           lowerOffset,
                           offset,
                           sets);
    }
    lowerOffset = offset;
  }
  return GatherWalls(volume, parts, sets);
}
} // namespace tissue
