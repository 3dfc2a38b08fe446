/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/HandleCutting.h"

#include "Nerve/KuhnWall.h"

#include <algorithm>
#include <bitset>
#include <limits>
#include <map>
#include <queue>
#include <set>

namespace tissue
{
namespace
{
constexpr std::int64_t MinimumOfCut = 8;
constexpr std::int64_t ShareOfCut = 25;
/** A cut may give a neighbour a handle, which is cut in the next pass. */
constexpr int MaximumNumberOfPasses = 3;

constexpr unsigned AllNeighbors = (1u << 14) - 1;

/** Of each set of the seven voxels after one, those of its label: what the simplices that it is the first voxel of add
 * to the Euler characteristic. */
const std::array<std::int8_t, 128> &
EulerTable()
{
  static const std::array<std::int8_t, 128> eulerTable = [] {
    std::array<std::int8_t, 128> table;
    for (int set = 0; set < 128; ++set)
    {
      const auto  isIn = [set](int axes) { return (set >> (axes - 1) & 1) != 0; };
      std::int8_t sum = 1;
      for (int a = 1; a < 8; ++a)
      {
        sum -= isIn(a) ? 1 : 0;
        for (int b = a + 1; b < 8; ++b)
        {
          const bool isTriangle = isIn(a) && isIn(b) && (a & b) == a;
          sum += isTriangle ? 1 : 0;
          sum -= isTriangle && b != 7 && isIn(7) ? 1 : 0;
        }
      }
      table[set] = sum;
    }
    return table;
  }();
  return eulerTable;
}

/** Of each neighbour of a voxel those that are neighbours of it as well, as bits. */
std::array<unsigned, 14>
FindCommonNeighbors()
{
  const auto &             steps = KuhnSteps();
  std::array<unsigned, 14> common{};
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    for (const VoxelIndex & step : steps)
    {
      const auto at = std::find(steps.begin(), steps.end(), steps[i] + step);
      common[i] |= at != steps.end() ? 1u << (at - steps.begin()) : 0u;
    }
  }
  return common;
}

/** Whether a set of neighbours is connected in the link of their voxel. */
bool
IsConnected(unsigned set, const std::array<unsigned, 14> & commonNeighbors)
{
  unsigned reached = set & (~set + 1); // the least bit
  for (unsigned before = 0; before != reached;)
  {
    before = reached;
    for (std::size_t i = 0; i < commonNeighbors.size(); ++i)
    {
      reached |= (reached >> i & 1) != 0 ? commonNeighbors[i] & set : 0u;
    }
  }
  return reached == set;
}

/** The sets of a voxel's neighbours with which it is a simple point: its link is a sphere, so the set spans a disk
 * where it and the rest are each connected. */
const std::bitset<1 << 14> &
SimpleSets()
{
  static const std::bitset<1 << 14> sets = [] {
    const auto           common = FindCommonNeighbors();
    std::bitset<1 << 14> simple;
    for (unsigned set = 1; set < AllNeighbors; ++set)
    {
      simple[set] = IsConnected(set, common) && IsConnected(AllNeighbors & ~set, common);
    }
    return simple;
  }();
  return sets;
}

/** \brief One piece of voxels, in a box of its own with two voxels around it, in which a voxel is a place. */
class CellShape
{
public:
  using Place = std::ptrdiff_t;

  CellShape(const LabelVolume & volume, const VoxelIndex & start)
  {
    const std::vector<VoxelIndex> voxels = Flood(volume, start);
    m_First = start;
    VoxelIndex last = start;
    for (const VoxelIndex & p : voxels)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        m_First[axis] = std::min(m_First[axis], p[axis]);
        last[axis] = std::max(last[axis], p[axis]);
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      m_First[axis] -= 2;
      m_Size[axis] = last[axis] + 3 - m_First[axis];
    }
    std::transform(KuhnSteps().begin(), KuhnSteps().end(), m_Steps.begin(), [&](const auto & s) { return PlaceOf(s); });
    m_IsInCell.assign(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * m_Size[2], false);
    for (const VoxelIndex & p : voxels)
    {
      m_Voxels.push_back(this->PlaceOf({ { p[0] - m_First[0], p[1] - m_First[1], p[2] - m_First[2] } }));
      m_IsInCell[m_Voxels.back()] = true;
    }
    this->FindCavities();
  }

  std::int64_t
  NumberOfVoxels() const
  {
    return static_cast<std::int64_t>(m_Voxels.size());
  }

  std::int32_t
  NumberOfHandles() const
  {
    std::int32_t characteristic = 0;
    for (const Place p : m_Voxels)
    {
      characteristic += EulerTable()[this->SetOf(p, m_IsInCell) & 127];
    }
    return 1 + m_NumberOfCavities - characteristic;
  }

  /** The voxels across the handles, in ascending order. */
  std::vector<VoxelIndex>
  FindCut() const
  {
    const std::vector<bool> ball = this->GrowBall();
    std::vector<VoxelIndex> cut;
    for (const Place p : m_Voxels)
    {
      if (!ball[p])
      {
        cut.push_back(this->ToImage(p));
      }
    }
    std::sort(cut.begin(), cut.end());
    return cut;
  }

private:
  static std::vector<VoxelIndex>
  Flood(const LabelVolume & volume, const VoxelIndex & start)
  {
    const VertexId          cell = volume.At(start[0], start[1], start[2]);
    KeySet                  found;
    std::vector<VoxelIndex> voxels{ start };
    found.Insert(KeyOfVoxel(volume, start));
    for (std::size_t i = 0; i < voxels.size(); ++i)
    {
      for (const VoxelIndex & step : KuhnSteps())
      {
        const VoxelIndex q = voxels[i] + step;
        if (volume.At(q[0], q[1], q[2]) == cell && found.Insert(KeyOfVoxel(volume, q)))
        {
          voxels.push_back(q);
        }
      }
    }
    return voxels;
  }

  Place
  PlaceOf(const VoxelIndex & inBox) const
  {
    return inBox[0] + m_Size[0] * (inBox[1] + static_cast<Place>(m_Size[1]) * inBox[2]);
  }

  VoxelIndex
  ToImage(Place p) const
  {
    return { { static_cast<std::int32_t>(m_First[0] + p % m_Size[0]),
               static_cast<std::int32_t>(m_First[1] + p / m_Size[0] % m_Size[1]),
               static_cast<std::int32_t>(m_First[2] + p / m_Size[0] / m_Size[1]) } };
  }

  /** Which neighbours of a place are in a set of places, as bits in the order of KuhnSteps(). */
  unsigned
  SetOf(Place p, const std::vector<bool> & places) const
  {
    unsigned set = 0;
    for (std::size_t i = 0; i < m_Steps.size(); ++i)
    {
      set |= places[p + m_Steps[i]] ? 1u << i : 0u;
    }
    return set;
  }

  /** Appends all places that are neither in the cell nor found, and that hang together with those of the list. */
  void
  FloodAround(std::vector<Place> & open, std::vector<bool> & isFound) const
  {
    while (!open.empty())
    {
      const Place p = open.back();
      open.pop_back();
      for (const Place step : m_Steps)
      {
        if (!m_IsInCell[p + step] && !isFound[p + step])
        {
          isFound[p + step] = true;
          open.push_back(p + step);
        }
      }
    }
  }

  /** Counts them, and fills them. */
  void
  FindCavities()
  {
    std::vector<bool>  isAround(m_IsInCell.size(), false);
    std::vector<Place> open;
    // The cell is two places from the box's border: there all are around it, the last ones without a look beyond.
    for (Place p = 0; p < static_cast<Place>(m_IsInCell.size()); ++p)
    {
      const VoxelIndex inBox{ { static_cast<std::int32_t>(p % m_Size[0]),
                                static_cast<std::int32_t>(p / m_Size[0] % m_Size[1]),
                                static_cast<std::int32_t>(p / m_Size[0] / m_Size[1]) } };
      std::int32_t     toBorder = m_Size[0];
      for (int axis = 0; axis < 3; ++axis)
      {
        toBorder = std::min({ toBorder, inBox[axis], m_Size[axis] - 1 - inBox[axis] });
      }
      isAround[p] = toBorder < 2;
      if (toBorder == 1)
      {
        open.push_back(p);
      }
    }
    this->FloodAround(open, isAround);
    m_IsFilled.assign(isAround.size(), false);
    std::transform(isAround.begin(), isAround.end(), m_IsFilled.begin(), [](bool around) { return !around; });
    for (Place p = 0; p < static_cast<Place>(m_IsFilled.size()); ++p)
    {
      if (m_IsFilled[p] && !m_IsInCell[p] && !isAround[p])
      {
        ++m_NumberOfCavities;
        isAround[p] = true;
        open.push_back(p);
        this->FloodAround(open, isAround);
      }
    }
  }

  /** Of each place of the filled cell how many steps it is from what is around; those of cavities come first. */
  std::vector<std::int32_t>
  FindDepths() const
  {
    std::vector<std::int32_t> depths(m_IsFilled.size(), 0);
    std::vector<Place>        layer;
    for (Place p = 0; p < static_cast<Place>(m_IsFilled.size()); ++p)
    {
      if (m_IsFilled[p])
      {
        const bool isAtBorder = this->SetOf(p, m_IsFilled) != AllNeighbors;
        depths[p] = m_IsInCell[p] ? (isAtBorder ? 1 : 0) : std::numeric_limits<std::int32_t>::max();
        if (depths[p] == 1)
        {
          layer.push_back(p);
        }
      }
    }
    for (std::size_t i = 0; i < layer.size(); ++i)
    {
      for (const Place step : m_Steps)
      {
        const Place q = layer[i] + step;
        if (m_IsFilled[q] && depths[q] == 0)
        {
          depths[q] = depths[layer[i]] + 1;
          layer.push_back(q);
        }
      }
    }
    return depths;
  }

  std::vector<bool>
  GrowBall() const
  {
    const std::vector<std::int32_t> depths = this->FindDepths();
    using Candidate = std::pair<std::int32_t, Place>; // depth, and of the same depth the first
    std::priority_queue<Candidate> candidates;
    std::vector<bool>              ball(m_IsFilled.size(), false);
    const auto                     add = [&](Place p) {
      ball[p] = true;
      for (const Place step : m_Steps)
      {
        if (m_IsFilled[p + step] && !ball[p + step])
        {
          candidates.emplace(depths[p + step], -(p + step));
        }
      }
    };
    add(std::max_element(depths.begin(), depths.end()) - depths.begin());
    while (!candidates.empty())
    {
      const Place p = -candidates.top().second;
      candidates.pop();
      if (!ball[p] && SimpleSets()[this->SetOf(p, ball)])
      {
        add(p);
      }
    }
    return ball;
  }

  VoxelIndex            m_First;
  VoxelIndex            m_Size;
  std::array<Place, 14> m_Steps;
  /** In the order of the flood. */
  std::vector<Place> m_Voxels;
  std::vector<bool>  m_IsInCell;
  /** With its cavities. */
  std::vector<bool> m_IsFilled;
  std::int32_t      m_NumberOfCavities = 0;
};

std::size_t
OffsetOf(const LabelVolume & volume, const VoxelIndex & p)
{
  return (static_cast<std::size_t>(p[2]) * volume.size[1] + p[1]) * volume.size[0] + p[0];
}

/** The connected parts of some voxels in ascending order. */
std::vector<std::vector<VoxelIndex>>
FindParts(const std::vector<VoxelIndex> & voxels)
{
  std::set<VoxelIndex>                 left(voxels.begin(), voxels.end());
  std::vector<std::vector<VoxelIndex>> parts;
  while (!left.empty())
  {
    std::vector<VoxelIndex> part{ *left.begin() };
    left.erase(left.begin());
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      for (const VoxelIndex & step : KuhnSteps())
      {
        if (left.erase(part[i] + step) != 0)
        {
          part.push_back(part[i] + step);
        }
      }
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

/** The vertex, but its own, that a part of a cell has most faces with, of several the least; its own where it has none.
 */
VertexId
FindReceiver(const LabelVolume & volume, const std::vector<VoxelIndex> & part)
{
  const VertexId                   cell = volume.At(part[0][0], part[0][1], part[0][2]);
  std::map<VertexId, std::int64_t> faces;
  for (const VoxelIndex & p : part)
  {
    for (const std::size_t face : { 0, 1, 3, 7, 8, 10 })
    {
      const VoxelIndex q = p + KuhnSteps()[face];
      ++faces[volume.At(q[0], q[1], q[2])];
    }
  }
  faces.erase(cell);
  const auto most =
    std::max_element(faces.begin(), faces.end(), [](const auto & a, const auto & b) { return a.second < b.second; });
  return most == faces.end() ? cell : most->first;
}

/** \brief Cuts the cells of a list, one after another. */
class Cutting
{
public:
  Cutting(LabelVolume & volume, VertexId numberOfVertices)
    : m_Volume(volume)
    , m_Starts(static_cast<std::size_t>(numberOfVertices), volume.vertices.size())
  {
    for (std::size_t i = volume.vertices.size(); i-- > 0;)
    {
      m_Starts[static_cast<std::size_t>(volume.vertices[i])] = i;
    }
  }

  /** The shape may have changed since the list was made: then there is nothing to do. */
  void
  Cut(VertexId cell)
  {
    if (!this->HasVoxels(cell))
    {
      return;
    }
    const CellShape    shape = this->ShapeOf(cell);
    const std::int32_t handles = shape.NumberOfHandles();
    if (handles <= 0)
    {
      return;
    }
    HandleCut & record = m_Records.emplace(cell, HandleCut{ cell, handles, handles, 0 }).first->second;
    const std::vector<VoxelIndex> cut = shape.FindCut();
    const auto                    size = static_cast<std::int64_t>(cut.size());
    record.handlesLeft = handles;
    if (size <= std::max(MinimumOfCut, shape.NumberOfVoxels() / ShareOfCut) && this->Give(cell, cut))
    {
      record.handlesLeft = 0;
      record.numberOfVoxels += size;
    }
  }

  HandleCuts
  TakeResult()
  {
    HandleCuts result;
    for (const auto & entry : m_Records)
    {
      result.cells.push_back(entry.second);
    }
    for (const std::size_t offset : m_Given)
    {
      result.ranges.push_back({ offset, offset + 1, m_Volume.vertices[offset] });
    }
    return result;
  }

private:
  bool
  HasVoxels(VertexId cell) const
  {
    return m_Starts[static_cast<std::size_t>(cell)] < m_Volume.vertices.size();
  }

  CellShape
  ShapeOf(VertexId cell) const
  {
    std::size_t offset = m_Starts[static_cast<std::size_t>(cell)];
    while (m_Volume.vertices[offset] != cell)
    {
      ++offset; // its first voxels have been cut off
    }
    const auto row = static_cast<std::size_t>(m_Volume.size[0]);
    const auto columns = static_cast<std::size_t>(m_Volume.size[1]);
    return CellShape(m_Volume,
                     { { static_cast<std::int32_t>(offset % row),
                         static_cast<std::int32_t>(offset / row % columns),
                         static_cast<std::int32_t>(offset / row / columns) } });
  }

  std::int32_t
  HandlesOf(const std::set<VertexId> & cells) const
  {
    std::int32_t sum = 0;
    for (const VertexId cell : cells)
    {
      sum += cell == ExteriorVertex ? 0 : this->ShapeOf(cell).NumberOfHandles();
    }
    return sum;
  }

  /** Gives the voxels to their neighbours, where that leaves fewer handles in all. */
  bool
  Give(VertexId cell, const std::vector<VoxelIndex> & cut)
  {
    std::set<VertexId>                            concerned{ cell };
    std::vector<std::pair<std::size_t, VertexId>> given;
    for (const std::vector<VoxelIndex> & part : FindParts(cut))
    {
      const VertexId receiver = FindReceiver(m_Volume, part);
      concerned.insert(receiver);
      for (const VoxelIndex & p : part)
      {
        given.emplace_back(OffsetOf(m_Volume, p), receiver);
      }
    }
    const std::int32_t before = this->HandlesOf(concerned);
    for (const auto & [offset, receiver] : given)
    {
      m_Volume.vertices[offset] = receiver;
    }
    if (this->HandlesOf(concerned) >= before)
    {
      for (const auto & entry : given)
      {
        m_Volume.vertices[entry.first] = cell;
      }
      return false;
    }
    for (const auto & [offset, receiver] : given)
    {
      m_Given.insert(offset);
      auto & start = m_Starts[static_cast<std::size_t>(receiver)];
      start = std::min(start, offset);
    }
    return true;
  }

  LabelVolume &                 m_Volume;
  std::vector<std::size_t>      m_Starts;
  std::map<VertexId, HandleCut> m_Records;
  std::set<std::size_t>         m_Given;
};
} // namespace

std::vector<std::int32_t>
FindEulerCharacteristics(const LabelVolume & volume, VertexId numberOfVertices, const Execution & execution)
{
  struct Term
  {
    VertexId    vertex;
    std::int8_t value;
  };
  std::vector<std::vector<Term>> ofPlane(static_cast<std::size_t>(volume.size[2]));
  execution.For(ofPlane.size(), [&](std::size_t plane) {
    const auto z = static_cast<std::int32_t>(plane);
    for (std::int32_t y = 0; y < volume.size[1]; ++y)
    {
      for (std::int32_t x = 0; x < volume.size[0]; ++x)
      {
        const VertexId vertex = volume.At(x, y, z);
        unsigned       set = 0;
        for (unsigned axes = 1; vertex != ExteriorVertex && axes < 8; ++axes)
        {
          const bool isIn = volume.At(x + (axes & 1), y + (axes >> 1 & 1), z + (axes >> 2)) == vertex;
          set |= isIn ? 1u << (axes - 1) : 0u;
        }
        if (vertex != ExteriorVertex && EulerTable()[set] != 0)
        {
          ofPlane[plane].push_back({ vertex, EulerTable()[set] });
        }
      }
    }
  });
  std::vector<std::int32_t> characteristics(static_cast<std::size_t>(numberOfVertices), 0);
  for (const auto & terms : ofPlane)
  {
    for (const Term & term : terms)
    {
      characteristics[static_cast<std::size_t>(term.vertex)] += term.value;
    }
  }
  return characteristics;
}

HandleCuts
CutHandles(LabelVolume & volume, VertexId numberOfVertices, const Execution & execution)
{
  std::vector<std::int32_t> characteristics = FindEulerCharacteristics(volume, numberOfVertices, execution);
  const auto                isSimple = [](std::int32_t characteristic) { return characteristic == 1; };
  if (std::all_of(characteristics.begin() + 1, characteristics.end(), isSimple))
  {
    return {};
  }
  Cutting cutting(volume, numberOfVertices);
  for (int pass = 0; pass < MaximumNumberOfPasses; ++pass)
  {
    if (pass > 0)
    {
      characteristics = FindEulerCharacteristics(volume, numberOfVertices, execution);
    }
    for (VertexId v = ExteriorVertex + 1; v < numberOfVertices; ++v)
    {
      if (characteristics[static_cast<std::size_t>(v)] != 1)
      {
        cutting.Cut(v);
      }
    }
  }
  return cutting.TakeResult();
}
} // namespace tissue
