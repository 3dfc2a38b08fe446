/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaneScan.h"

#include <algorithm>
#include <cstring>

namespace tissue
{
namespace
{
void
FindDifferences(const VertexId * a, const VertexId * b, std::size_t count, std::uint8_t * differ)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    differ[i] = a[i] != b[i] ? 1 : 0;
  }
}
} // namespace

PlaneScan::PlaneScan(const LabelVolume & volume, std::int32_t z)
  : m_Volume(volume)
  , m_Width(static_cast<std::size_t>(volume.size[0]) + 2)
  , m_Z(z)
{
  std::copy(volume.size.begin(), volume.size.end(), m_Size.begin());
  const std::size_t size = m_Width * (m_Size[1] + 2);
  for (Plane * plane : { &m_Plane, &m_Above })
  {
    plane->labels.assign(size, ExteriorVertex);
    plane->differsInX.assign(size, 0);
    plane->differsInY.assign(size, 0);
  }
  m_DiffersInZ.assign(size, 0);
  m_Flags.assign(size + WordSize, 0);
  this->Read(z, m_Plane);
  this->Read(z + 1, m_Above);
  this->Compare();
}

void
PlaneScan::Advance()
{
  ++m_Z;
  std::swap(m_Plane, m_Above);
  this->Read(m_Z + 1, m_Above);
  this->Compare();
}

void
PlaneScan::Read(std::int32_t z, Plane & plane) const
{
  if (z < 0 || z >= m_Volume.size[2])
  {
    std::fill(plane.labels.begin(), plane.labels.end(), ExteriorVertex);
  }
  else
  {
    m_Volume.vertices.Visit([&](const auto * vertices) {
      const auto * row = vertices + static_cast<std::size_t>(z) * m_Size[1] * m_Size[0];
      for (std::size_t y = 1; y <= m_Size[1]; ++y, row += m_Size[0])
      {
        std::copy(row, row + m_Size[0], plane.labels.begin() + static_cast<std::ptrdiff_t>(y * m_Width + 1));
      }
    });
  }
  // From the end of a row to the next one it is from border to border: no difference.
  const VertexId * labels = plane.labels.data();
  FindDifferences(labels, labels + 1, this->Size() - 1, plane.differsInX.data());
  FindDifferences(labels, labels + m_Width, this->Size() - m_Width, plane.differsInY.data());
}

void
PlaneScan::Compare()
{
  FindDifferences(m_Plane.labels.data(), m_Above.labels.data(), this->Size(), m_DiffersInZ.data());
  const std::size_t          w = m_Width;
  const std::uint8_t * const x = m_Plane.differsInX.data();
  const std::uint8_t * const xAbove = m_Above.differsInX.data();
  const std::uint8_t * const y = m_Plane.differsInY.data();
  const std::uint8_t * const yAbove = m_Above.differsInY.data();
  const std::uint8_t * const z = m_DiffersInZ.data();
  std::uint8_t * const       flags = m_Flags.data();
  const std::size_t          count = this->Size() - w - 1;
  for (std::size_t p = 0; p < count; ++p)
  {
    const std::uint8_t isAlongX = x[p] | x[p + w] | xAbove[p] | xAbove[p + w];
    const std::uint8_t isAlongY = y[p] | y[p + 1] | yAbove[p] | yAbove[p + 1];
    const std::uint8_t isAlongZ = z[p] | z[p + 1] | z[p + w] | z[p + w + 1];
    const std::uint8_t isAroundX = y[p] & yAbove[p] & z[p] & z[p + w];
    const std::uint8_t isAroundY = x[p] & xAbove[p] & z[p] & z[p + 1];
    const std::uint8_t isAroundZ = x[p] & x[p + w] & y[p] & y[p + 1];
    const std::uint8_t isVaried = (isAlongX & isAlongY & isAlongZ) | isAroundX | isAroundY | isAroundZ;
    flags[p] = static_cast<std::uint8_t>(IsVaried * isVaried + (x[p] | y[p] | z[p]));
  }
}

std::size_t
PlaneScan::FindPlaces(std::size_t y, std::vector<std::uint32_t> & places) const
{
  const std::uint8_t * const flags = m_Flags.data() + y * m_Width;
  const std::size_t          end = m_Width - 1;
  std::size_t                count = 0;
  for (std::size_t begin = 0; begin < end; begin += WordSize)
  {
    std::uint64_t word = 0;
    std::memcpy(&word, flags + begin, WordSize);
    const std::size_t endOfWord = word == 0 ? begin : std::min(begin + WordSize, end);
    for (std::size_t x = begin; x < endOfWord; ++x)
    {
      // Nothing would foretell a branch here.
      places[count] = static_cast<std::uint32_t>(x);
      count += flags[x] != 0 ? 1 : 0;
    }
  }
  return count;
}

std::vector<Slab>
SlabsOf(const LabelVolume & volume)
{
  // Few slabs, as each joins its walls to those of the one before, and yet one for each of many threads.
  constexpr std::int32_t planesPerSlab = 32;
  std::vector<Slab>      slabs;
  for (std::int32_t begin = -1; begin < volume.size[2]; begin += planesPerSlab)
  {
    slabs.push_back({ begin, std::min(begin + planesPerSlab, volume.size[2]) });
  }
  return slabs;
}

void
VisitVariedBlocks(const LabelVolume & volume, const BlockVisitor & visit, const Execution & execution)
{
  const std::vector<Slab> slabs = SlabsOf(volume);
  execution.For(slabs.size(), [&](std::size_t slab) {
    PlaneScan scan(volume, slabs[slab].begin);
    for (std::int32_t z = slabs[slab].begin; z < slabs[slab].end; ++z)
    {
      if (z > slabs[slab].begin)
      {
        scan.Advance();
      }
      scan.Visit([](std::size_t, const VoxelIndex &) {}, [&](const CrowdedBlock & block) { visit(slab, block); });
    }
  });
}

std::vector<CrowdedBlock>
CrowdedBlockGathering::TakeBlocks()
{
  std::size_t count = 0;
  for (const std::vector<CrowdedBlock> & ofSlab : m_OfSlab)
  {
    count += ofSlab.size();
  }
  std::vector<CrowdedBlock> blocks;
  blocks.reserve(count);
  for (std::vector<CrowdedBlock> & ofSlab : m_OfSlab)
  {
    blocks.insert(blocks.end(), ofSlab.begin(), ofSlab.end());
    ofSlab = std::vector<CrowdedBlock>();
  }
  return blocks;
}
} // namespace tissue
