/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/LabelDivision.h"

#include "Nerve/GeodesicSeeds.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** Steps from a wall that the layer around it reaches into the exterior. */
constexpr int LayerSteps = 2;
/** Exterior around the image: the layer of a wall at its border, and the voxel at the wall. */
constexpr std::int32_t Padding = LayerSteps + 1;
constexpr int          MaximumNumberOfRounds = 6;

/** Whether all voxels that are less than Padding steps from the outside are exterior. */
bool
HasPadding(const LabelVolume & volume)
{
  const auto isNearEnd = [](std::int32_t i, std::int32_t size) { return i < Padding || i >= size - Padding; };
  for (std::int32_t z = 0; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < volume.size[1]; ++y)
    {
      const bool isWholeRow = isNearEnd(z, volume.size[2]) || isNearEnd(y, volume.size[1]);
      for (std::int32_t x = 0; x < volume.size[0]; ++x)
      {
        if (!isWholeRow && x == Padding)
        {
          x = std::max(x, volume.size[0] - Padding);
        }
        if (x < volume.size[0] && volume.At(x, y, z) != ExteriorVertex)
        {
          return false;
        }
      }
    }
  }
  return true;
}

LabelVolume
Pad(const LabelVolume & volume)
{
  LabelVolume padded;
  padded.steps = volume.steps;
  padded.origin = volume.ToPhysical({ { -1.0 * Padding, -1.0 * Padding, -1.0 * Padding } });
  std::transform(
    volume.size.begin(), volume.size.end(), padded.size.begin(), [](std::int32_t s) { return s + 2 * Padding; });
  padded.vertices.assign(static_cast<std::size_t>(padded.size[0]) * padded.size[1] * padded.size[2], ExteriorVertex);
  for (std::int32_t z = 0; z < volume.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < volume.size[1]; ++y)
    {
      const auto from =
        volume.vertices.begin() + (static_cast<std::ptrdiff_t>(z) * volume.size[1] + y) * volume.size[0];
      const auto to = (static_cast<std::ptrdiff_t>(z + Padding) * padded.size[1] + y + Padding) * padded.size[0];
      std::copy(from, from + volume.size[0], padded.vertices.begin() + to + Padding);
    }
  }
  return padded;
}

std::size_t
OffsetOf(const LabelVolume & volume, const VoxelIndex & p)
{
  return (static_cast<std::size_t>(p[2]) * volume.size[1] + p[1]) * volume.size[0] + p[0];
}

bool
IsWithin(const LabelVolume & volume, const VoxelIndex & p)
{
  return p[0] >= 0 && p[1] >= 0 && p[2] >= 0 && p[0] < volume.size[0] && p[1] < volume.size[1] && p[2] < volume.size[2];
}

/** Voxels of one label that hang together, and how large they are. */
struct Region
{
  static constexpr std::int64_t Unbounded = std::numeric_limits<std::int64_t>::max();

  std::vector<VoxelIndex> voxels;
  /** Voxels of the box around it. */
  std::int64_t boxSize;
};

class Division
{
public:
  Division(LabelVolume volume, VertexId numberOfVertices, std::vector<KuhnEdge> starts)
    : m_Volume(std::move(volume))
    , m_Starts(std::move(starts))
  {
    if (!HasPadding(m_Volume))
    {
      m_Volume = Pad(m_Volume);
      const VoxelIndex shift{ { Padding, Padding, Padding } };
      std::transform(m_Starts.begin(), m_Starts.end(), m_Starts.begin(), [&](const KuhnEdge & start) {
        return KuhnEdge{ start.first + shift, start.second + shift };
      });
    }
    for (VertexId v = 0; v < numberOfVertices; ++v)
    {
      m_RealOf.push_back(v);
    }
  }

  LabelDivision
  Run()
  {
    for (int round = 0; round < MaximumNumberOfRounds && !m_Starts.empty(); ++round)
    {
      this->RunRound();
    }
    LabelDivision                    result;
    std::map<VertexId, std::int32_t> pieces;
    for (std::size_t v = 0; v < m_RealOf.size(); ++v)
    {
      ++pieces[m_RealOf[v]];
    }
    for (const auto & [cell, count] : pieces)
    {
      if (count > 1)
      {
        result.cells.push_back({ cell, count });
      }
    }
    result.volume = std::move(m_Volume);
    result.realOf = std::move(m_RealOf);
    return result;
  }

private:
  /** What of a vertex is to be divided: the voxels at the side of each faulty wall. */
  using Surfaces = std::vector<std::vector<VoxelIndex>>;

  VertexId
  At(const VoxelIndex & p) const
  {
    return m_Volume.At(p[0], p[1], p[2]);
  }

  bool
  IsOutside(VertexId v) const
  {
    return m_RealOf[static_cast<std::size_t>(v)] == ExteriorVertex;
  }

  void
  RunRound()
  {
    std::map<VertexId, Surfaces> ofVertex;
    KuhnWallSearch               search(m_Volume);
    m_Regions.clear();
    for (std::size_t i = 0; i < m_Starts.size(); ++i)
    {
      const KuhnEdge start = m_Starts[i];
      if (this->IsOutside(this->At(start.first)) && this->IsOutside(this->At(start.second)))
      {
        continue;
      }
      auto wall = search.Find(start);
      if (!wall || wall->IsSound())
      {
        continue;
      }
      for (const KuhnTriangle & line : wall->closedLines)
      {
        m_Starts.push_back({ line.edge.first, line.third });
        m_Starts.push_back({ line.edge.second, line.third });
      }
      if (!this->IsForThird(*wall))
      {
        const int larger = this->FindLarger(start.first, start.second);
        ofVertex[wall->cells[larger]].push_back(std::move(wall->voxels[larger]));
      }
    }
    m_Starts.clear();
    for (const auto & [vertex, surfaces] : ofVertex)
    {
      this->Divide(vertex, surfaces);
    }
  }

  /** A line without corners that is all of the wall's boundary gets some when the largest of its cells is divided. */
  bool
  IsForThird(const KuhnWall & wall)
  {
    if (wall.numberOfCircles > 0 || wall.closedLines.size() != 1)
    {
      return false;
    }
    const VoxelIndex & third = wall.closedLines[0].third;
    return this->FindLarger(wall.start.first, third) == 1 && this->FindLarger(wall.start.second, third) == 1;
  }

  /** Which of the regions of two voxels is larger: 0 or 1. Of the same size it is the exterior, then the one of the
   * lesser vertex. */
  int
  FindLarger(const VoxelIndex & a, const VoxelIndex & b)
  {
    const VertexId vertices[] = { this->At(a), this->At(b) };
    std::int64_t   sizes[] = { 0, 0 };
    for (const int i : { 0, 1 })
    {
      sizes[i] = vertices[i] == ExteriorVertex ? 0 : this->RegionOf(vertices[i], i == 0 ? a : b).boxSize;
    }
    for (const int i : { 0, 1 })
    {
      if (vertices[i] == ExteriorVertex)
      {
        sizes[i] = this->Flood(i == 0 ? a : b, sizes[1 - i]).boxSize;
      }
    }
    if (sizes[0] != sizes[1])
    {
      return sizes[0] > sizes[1] ? 0 : 1;
    }
    return vertices[0] < vertices[1] ? 0 : 1;
  }

  const Region &
  RegionOf(VertexId v, const VoxelIndex & voxel)
  {
    auto at = m_Regions.find(v);
    if (at == m_Regions.end())
    {
      at = m_Regions.emplace(v, this->Flood(voxel, Region::Unbounded)).first;
    }
    return at->second;
  }

  /** The region of a voxel; unbounded where it has left the image or its box become larger than the limit. */
  Region
  Flood(const VoxelIndex & start, std::int64_t limit) const
  {
    const VertexId vertex = this->At(start);
    Region         region{ { start }, 1 };
    KeySet         found;
    VoxelIndex     least = start;
    VoxelIndex     most = start;
    for (std::size_t i = 0; i < region.voxels.size(); ++i)
    {
      if (!IsWithin(m_Volume, region.voxels[i]) || region.boxSize > limit)
      {
        region.boxSize = Region::Unbounded;
        return region;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        least[axis] = std::min(least[axis], region.voxels[i][axis]);
        most[axis] = std::max(most[axis], region.voxels[i][axis]);
      }
      region.boxSize = std::int64_t{ most[0] - least[0] + 1 } * (most[1] - least[1] + 1) * (most[2] - least[2] + 1);
      for (const VoxelIndex & step : KuhnSteps())
      {
        const VoxelIndex next = region.voxels[i] + step;
        if (next != start && this->At(next) == vertex && found.Insert(KeyOfVoxel(m_Volume, next)))
        {
          region.voxels.push_back(next);
        }
      }
    }
    return region;
  }

  /** What of the exterior is at the surfaces. */
  std::vector<VoxelIndex>
  FindLayer(const Surfaces & surfaces) const
  {
    std::vector<VoxelIndex> layer;
    KeySet                  found;
    const auto              add = [&](const VoxelIndex & p) {
      if (IsWithin(m_Volume, p) && this->At(p) == ExteriorVertex && found.Insert(KeyOfVoxel(m_Volume, p)))
      {
        layer.push_back(p);
      }
    };
    for (const auto & voxels : surfaces)
    {
      std::for_each(voxels.begin(), voxels.end(), add);
    }
    std::size_t begin = 0;
    for (int step = 0; step < LayerSteps; ++step)
    {
      const std::size_t end = layer.size();
      for (; begin < end; ++begin)
      {
        for (const VoxelIndex & s : KuhnSteps())
        {
          add(layer[begin] + s);
        }
      }
    }
    return layer;
  }

  void
  Divide(VertexId vertex, const Surfaces & surfaces)
  {
    GeodesicSeeds seeds(m_Volume,
                        vertex == ExteriorVertex ? this->FindLayer(surfaces)
                                                 : this->RegionOf(vertex, surfaces.front().front()).voxels);
    for (const auto & surface : surfaces)
    {
      seeds.Cover(surface);
    }
    // The first piece of a cell keeps its vertex; the exterior keeps what is not in the layer.
    const VertexId first = static_cast<VertexId>(m_RealOf.size()) - (vertex == ExteriorVertex ? 0 : 1);
    m_RealOf.resize(static_cast<std::size_t>(first + seeds.NumberOfSeeds()),
                    m_RealOf[static_cast<std::size_t>(vertex)]);
    const auto & region = seeds.GetRegion();
    for (std::size_t i = 0; i < region.size(); ++i)
    {
      if (vertex == ExteriorVertex || seeds.SeedOf(i) > 0)
      {
        m_Volume.vertices[OffsetOf(m_Volume, region[i])] = first + seeds.SeedOf(i);
      }
    }
    if (seeds.NumberOfSeeds() > 1)
    {
      this->AppendStarts(region);
    }
  }

  /** Of all walls of the region. */
  void
  AppendStarts(const std::vector<VoxelIndex> & region)
  {
    for (const VoxelIndex & p : region)
    {
      for (const VoxelIndex & step : KuhnSteps())
      {
        if (this->At(p) != this->At(p + step))
        {
          m_Starts.push_back({ p, p + step });
        }
      }
    }
  }

  LabelVolume           m_Volume;
  std::vector<KuhnEdge> m_Starts;
  std::vector<VertexId> m_RealOf;
  /** Of vertices but the exterior, as they are at the beginning of a round. */
  std::map<VertexId, Region> m_Regions;
};
} // namespace

LabelDivision
DivideLabels(LabelVolume volume, VertexId numberOfVertices, const std::vector<KuhnEdge> & starts)
{
  KuhnWallSearch        search(volume);
  std::vector<KuhnEdge> faulty;
  for (const KuhnEdge & start : starts)
  {
    const auto wall = search.Find(start);
    if (wall && !wall->IsSound())
    {
      faulty.push_back(start);
    }
  }
  return faulty.empty() ? LabelDivision() : Division(std::move(volume), numberOfVertices, std::move(faulty)).Run();
}

std::vector<KuhnEdge>
FindDoubtfulWalls(const LabelVolume & volume, const std::vector<ImageWall> & walls, const GeneralComplex & nerve)
{
  std::map<VertexPair, int> balance;
  for (const GeneralComplex::Edge & edge : nerve.FindEdges())
  {
    ++balance[edge.vertices];
  }
  for (const ImageWall & wall : walls)
  {
    --balance[wall.cells];
  }
  const auto            at = [&](const VoxelIndex & p) { return volume.At(p[0], p[1], p[2]); };
  std::vector<KuhnEdge> starts;
  for (const ImageWall & wall : walls)
  {
    // Small fragments have other cells by now.
    if (balance[wall.cells] != 0 && at(wall.face[0]) != at(wall.face[1]))
    {
      starts.push_back({ wall.face[0], wall.face[1] });
    }
  }
  return starts;
}
} // namespace tissue
