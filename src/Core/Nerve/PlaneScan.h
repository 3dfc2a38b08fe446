/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PlaneScan_h
#define TissueTessellationCore_PlaneScan_h

#include "Nerve/CrowdedBlocks.h"

#include <cstdint>
#include <functional>

namespace tissue
{
/** \brief The planes of an image one after the other, each with that above it and with a border of one voxel of
 * exterior, and where in them there is something to know.
 *
 * Nearly everywhere a voxel is of the same cell as the next one along each axis, and a block of 2x2x2 voxels is the
 * same all along one of the axes: of one cell, or cut by a wall or along a line that is straight there. A block that is
 * the same along an axis has at most four cells, those of a face of it, and adds nothing to the Euler characteristic of
 * a cell: of the simplices whose first voxel is the block's, each two that differ by a step along the axis cancel out.
 * So all that is to be known of blocks is in those that vary along all axes, and those with a face around which no two
 * voxels in turn are of one cell. */
class PlaneScan
{
public:
  /** Of the plane z of the image, and that above it: each may be outside. */
  PlaneScan(const LabelVolume & volume, std::int32_t z);

  /** Goes to the next plane. */
  void
  Advance();

  /** Voxels of a row, and of a plane, with the border. */
  std::size_t
  Width() const
  {
    return m_Width;
  }
  std::size_t
  Size() const
  {
    return m_Plane.labels.size();
  }

  /** The cells of a voxel of the plane, by its number in it, and of the next ones along each axis. */
  std::array<VertexId, 4>
  CellsAt(std::size_t p) const
  {
    return { { m_Plane.labels[p], m_Plane.labels[p + 1], m_Plane.labels[p + m_Width], m_Above.labels[p] } };
  }

  /** Calls visitFaces(p, x, y, z) for each voxel that is not of the same cell as the next one along each axis, and
   * visitBlock(block) for the blocks of the plane and that above in which there is something to know, and perhaps for
   * a few others; in raster order. */
  template <typename TVisitFaces, typename TVisitBlock>
  void
  Visit(const TVisitFaces & visitFaces, const TVisitBlock & visitBlock) const
  {
    std::vector<std::uint32_t> places(m_Width);
    for (std::size_t y = 0; y <= m_Size[1]; ++y)
    {
      const std::size_t count = this->FindPlaces(y, places);
      for (std::size_t i = 0; i < count; ++i)
      {
        const std::size_t p = y * m_Width + places[i];
        const VoxelIndex  voxel{ { static_cast<std::int32_t>(places[i]) - 1, static_cast<std::int32_t>(y) - 1, m_Z } };
        if ((m_Flags[p] & HasFaces) != 0)
        {
          visitFaces(p, voxel);
        }
        if ((m_Flags[p] & IsVaried) != 0)
        {
          visitBlock(CrowdedBlock{ voxel, this->BlockAt(p) });
        }
      }
    }
  }

private:
  static constexpr std::uint8_t HasFaces = 1;
  static constexpr std::uint8_t IsVaried = 2;
  /** Voxels that are passed over together. */
  static constexpr std::size_t WordSize = 8;

  /** For each voxel of a plane: compilers compare many voxels at once where the results are bytes. */
  using Flags = std::vector<std::uint8_t>;

  /** Labels, and whether the next voxel along a row, and in the next row, is of another cell. */
  struct Plane
  {
    std::vector<VertexId> labels;
    Flags                 differsInX;
    Flags                 differsInY;
  };

  void
  Read(std::int32_t z, Plane & plane) const;

  void
  Compare();

  /** The places in a row where there is anything, which are the first ones of the list; returns their number. */
  std::size_t
  FindPlaces(std::size_t y, std::vector<std::uint32_t> & places) const;

  BlockVoxels
  BlockAt(std::size_t p) const
  {
    const VertexId * const below = m_Plane.labels.data() + p;
    const VertexId * const above = m_Above.labels.data() + p;
    return {
      { below[0], below[1], below[m_Width], below[m_Width + 1], above[0], above[1], above[m_Width], above[m_Width + 1] }
    };
  }

  const LabelVolume &        m_Volume;
  std::array<std::size_t, 3> m_Size;
  std::size_t                m_Width;
  std::int32_t               m_Z;
  Plane                      m_Plane;
  Plane                      m_Above;
  Flags                      m_DiffersInZ;
  Flags                      m_Flags;
};

/** The slabs of planes that an image is read in, [begin, end) each, from the plane in front of the image on. */
struct Slab
{
  std::int32_t begin;
  std::int32_t end;
};

std::vector<Slab>
SlabsOf(const LabelVolume & volume);

/** Called with the number of a slab, and a block of it; of one slab in raster order, of several slabs at once. */
using BlockVisitor = std::function<void(std::size_t, const CrowdedBlock &)>;

/** Visits the blocks of the image in which there is something to know; slabs are read in parallel. */
void
VisitVariedBlocks(const LabelVolume & volume, const BlockVisitor & visit, const Execution & execution);

/** \brief Keeps the crowded ones of the blocks that it is shown. */
class CrowdedBlockGathering
{
public:
  explicit CrowdedBlockGathering(const LabelVolume & volume)
    : m_OfSlab(SlabsOf(volume).size())
  {}

  void
  Add(std::size_t slab, const CrowdedBlock & block)
  {
    if (IsCrowded(block.cells))
    {
      m_OfSlab[slab].push_back(block);
    }
  }

  /** In raster order. */
  std::vector<CrowdedBlock>
  TakeBlocks();

private:
  std::vector<std::vector<CrowdedBlock>> m_OfSlab;
};
} // namespace tissue

#endif
