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

/** What the simplices that a voxel is the first of add to the Euler characteristic of its vertex. */
std::int8_t
EulerTerm(const BlockVoxels & voxels)
{
  unsigned set = 0;
  for (unsigned axes = 1; axes < 8; ++axes)
  {
    set |= voxels[axes] == voxels[0] ? 1u << (axes - 1) : 0u;
  }
  return EulerTable()[set];
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

/** \brief The voxels of a cell, in a box of their own with two voxels around it, in which a voxel is a place. */
class CellShape
{
public:
  using Place = std::ptrdiff_t;
  /** Of each place of the box: bytes, as single bits take longer to come by. */
  using PlaceSet = std::vector<std::uint8_t>;

  /** The voxels of a vertex, all of them in a box. */
  CellShape(const LabelVolume & volume, VertexId cell, const VoxelBox & box)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      m_First[axis] = box.least[axis] - 2;
      m_Size[axis] = box.most[axis] + 3 - m_First[axis];
    }
    std::transform(KuhnSteps().begin(), KuhnSteps().end(), m_Steps.begin(), [&](const auto & s) { return PlaceOf(s); });
    m_IsInCell.assign(static_cast<std::size_t>(m_Size[0]) * m_Size[1] * m_Size[2], 0);
    for (std::int32_t z = box.least[2]; z <= box.most[2]; ++z)
    {
      for (std::int32_t y = box.least[1]; y <= box.most[1]; ++y)
      {
        for (std::int32_t x = box.least[0]; x <= box.most[0]; ++x)
        {
          if (volume.vertices[OffsetOf(volume, { { x, y, z } })] == cell)
          {
            m_Voxels.push_back(this->PlaceOf({ { x - m_First[0], y - m_First[1], z - m_First[2] } }));
            m_IsInCell[m_Voxels.back()] = 1;
          }
        }
      }
    }
    this->FindCavities();
  }

  std::int64_t
  NumberOfVoxels() const
  {
    return static_cast<std::int64_t>(m_Voxels.size());
  }

  std::int32_t
  NumberOfCavities() const
  {
    return m_NumberOfCavities;
  }

  /** The voxels across the handles, in ascending order. */
  std::vector<VoxelIndex>
  FindCut() const
  {
    const PlaceSet          ball = this->GrowBall();
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
  SetOf(Place p, const PlaceSet & places) const
  {
    unsigned set = 0;
    for (std::size_t i = 0; i < m_Steps.size(); ++i)
    {
      set |= unsigned{ places[p + m_Steps[i]] } << i;
    }
    return set;
  }

  /** Finds all places that are not found yet and that hang together with those of the list, which it empties. */
  void
  FloodAround(std::vector<Place> & open, PlaceSet & isFound) const
  {
    while (!open.empty())
    {
      const Place p = open.back();
      open.pop_back();
      for (const Place step : m_Steps)
      {
        if (isFound[p + step] == 0)
        {
          isFound[p + step] = 1;
          open.push_back(p + step);
        }
      }
    }
  }

  /** Counts them, and fills them. */
  void
  FindCavities()
  {
    PlaceSet           isFound = m_IsInCell;
    std::vector<Place> open;
    // The cell is two places from the box's border: there all are around it, the last ones without a look beyond.
    Place p = 0;
    for (std::int32_t z = 0; z < m_Size[2]; ++z)
    {
      for (std::int32_t y = 0; y < m_Size[1]; ++y)
      {
        const std::int32_t toBorder = std::min({ y, m_Size[1] - 1 - y, z, m_Size[2] - 1 - z });
        for (std::int32_t x = 0; x < m_Size[0]; ++x, ++p)
        {
          const std::int32_t least = std::min({ toBorder, x, m_Size[0] - 1 - x });
          isFound[p] |= least < 2 ? 1 : 0;
          if (least == 1)
          {
            open.push_back(p);
          }
        }
      }
    }
    this->FloodAround(open, isFound);
    m_IsFilled = m_IsInCell;
    std::transform(isFound.begin(), isFound.end(), m_IsFilled.begin(), m_IsFilled.begin(), [](int found, int inCell) {
      return static_cast<std::uint8_t>(found == 0 || inCell != 0 ? 1 : 0);
    });
    for (p = 0; p < static_cast<Place>(isFound.size()); ++p)
    {
      if (isFound[p] == 0)
      {
        ++m_NumberOfCavities;
        isFound[p] = 1;
        open.push_back(p);
        this->FloodAround(open, isFound);
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

  PlaceSet
  GrowBall() const
  {
    const std::vector<std::int32_t> depths = this->FindDepths();
    using Candidate = std::pair<std::int32_t, Place>; // depth, and of the same depth the first
    std::priority_queue<Candidate> candidates;
    PlaceSet                       ball(m_IsFilled.size(), 0);
    PlaceSet                       isCandidate(m_IsFilled.size(), 0);
    const auto                     add = [&](Place p) {
      ball[p] = 1;
      for (const Place step : m_Steps)
      {
        if (m_IsFilled[p + step] && !ball[p + step] && !isCandidate[p + step])
        {
          isCandidate[p + step] = 1;
          candidates.emplace(depths[p + step], -(p + step));
        }
      }
    };
    add(std::max_element(depths.begin(), depths.end()) - depths.begin());
    while (!candidates.empty())
    {
      const Place p = -candidates.top().second;
      candidates.pop();
      isCandidate[p] = 0; // a voxel that is refused comes again with the next one beside it
      if (SimpleSets()[this->SetOf(p, ball)])
      {
        add(p);
      }
    }
    return ball;
  }

  VoxelIndex            m_First;
  VoxelIndex            m_Size;
  std::array<Place, 14> m_Steps;
  /** Ascending. */
  std::vector<Place> m_Voxels;
  PlaceSet           m_IsInCell;
  /** With its cavities. */
  PlaceSet     m_IsFilled;
  std::int32_t m_NumberOfCavities = 0;
};

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
  /** \param characteristics of the volume's vertices (FindEulerCharacteristics()). */
  Cutting(LabelVolume & volume, std::vector<std::int32_t> characteristics, std::vector<VoxelBox> boxes)
    : m_Volume(volume)
    , m_Boxes(std::move(boxes))
    , m_Characteristics(std::move(characteristics))
  {}

  /** As the volume is by now. */
  const std::vector<std::int32_t> &
  GetCharacteristics() const
  {
    return m_Characteristics;
  }

  void
  Cut(VertexId cell)
  {
    if (m_Boxes[static_cast<std::size_t>(cell)].IsEmpty() || m_Scaffolds.count(cell) != 0)
    {
      return;
    }
    const CellShape    shape = this->ShapeOf(cell);
    const std::int32_t handles = this->HandlesOf(cell, shape);
    if (handles <= 0)
    {
      return;
    }
    HandleCut & record = m_Records.emplace(cell, HandleCut{ cell, handles, handles, 0 }).first->second;
    const std::vector<VoxelIndex> cut = shape.FindCut();
    const auto                    size = static_cast<std::int64_t>(cut.size());
    record.handlesLeft = handles;
    if (size > std::max(MinimumOfCut, shape.NumberOfVoxels() / ShareOfCut))
    {
      m_Scaffolds.insert(cell);
    }
    else if (this->Give(cell, cut))
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
    for (const auto & entry : m_Given)
    {
      const VoxelChange & change = entry.second;
      if (m_Volume.vertices[entry.first] != change.before)
      {
        result.changes.push_back(change);
      }
    }
    return result;
  }

private:
  CellShape
  ShapeOf(VertexId cell) const
  {
    return CellShape(m_Volume, cell, m_Boxes[static_cast<std::size_t>(cell)]);
  }

  /** The cell is one piece. */
  std::int32_t
  HandlesOf(VertexId cell, const CellShape & shape) const
  {
    return 1 + shape.NumberOfCavities() - m_Characteristics[static_cast<std::size_t>(cell)];
  }

  std::int32_t
  HandlesOf(const std::set<VertexId> & cells) const
  {
    std::int32_t sum = 0;
    for (const VertexId cell : cells)
    {
      sum += cell == ExteriorVertex ? 0 : this->HandlesOf(cell, this->ShapeOf(cell));
    }
    return sum;
  }

  /** Gives the voxels to their neighbours, where that leaves fewer handles in all. */
  bool
  Give(VertexId cell, const std::vector<VoxelIndex> & cut)
  {
    std::set<VertexId>      concerned{ cell };
    std::vector<GivenVoxel> given;
    for (const std::vector<VoxelIndex> & part : FindParts(cut))
    {
      const VertexId receiver = FindReceiver(m_Volume, part);
      concerned.insert(receiver);
      for (const VoxelIndex & p : part)
      {
        given.push_back({ p, receiver });
      }
    }
    const std::int32_t before = this->HandlesOf(concerned);
    this->Exchange(given);
    if (this->HandlesOf(concerned) >= before)
    {
      this->Exchange(given);
      return false;
    }
    for (const GivenVoxel & voxel : given)
    {
      // A voxel that is given again keeps its first vertex here.
      m_Given.emplace(OffsetOf(m_Volume, voxel.place), VoxelChange{ voxel.place, cell });
    }
    return true;
  }

  struct GivenVoxel
  {
    VoxelIndex place;
    VertexId   vertex;
  };

  /** Gives the voxels the vertices of the list, and the list those that they had. */
  void
  Exchange(std::vector<GivenVoxel> & voxels)
  {
    std::set<VoxelIndex> bases;
    for (const GivenVoxel & voxel : voxels)
    {
      bases.insert(voxel.place);
      for (std::size_t descending = 7; descending < KuhnSteps().size(); ++descending)
      {
        bases.insert(voxel.place + KuhnSteps()[descending]);
      }
    }
    this->AddTerms(bases, -1);
    for (GivenVoxel & voxel : voxels)
    {
      m_Boxes[static_cast<std::size_t>(voxel.vertex)].Add(voxel.place);
      m_Scaffolds.erase(voxel.vertex);
      const VertexId before = m_Volume.vertices[OffsetOf(m_Volume, voxel.place)];
      m_Volume.vertices.Put(OffsetOf(m_Volume, voxel.place), voxel.vertex);
      voxel.vertex = before;
    }
    this->AddTerms(bases, 1);
  }

  void
  AddTerms(const std::set<VoxelIndex> & bases, std::int32_t factor)
  {
    for (const VoxelIndex & p : bases)
    {
      BlockVoxels voxels;
      for (int set = 0; set < 8; ++set)
      {
        voxels[set] = m_Volume.At(p[0] + (set & 1), p[1] + (set >> 1 & 1), p[2] + (set >> 2));
      }
      m_Characteristics[static_cast<std::size_t>(voxels[0])] +=
        voxels[0] != ExteriorVertex ? factor * EulerTerm(voxels) : 0;
    }
  }

  LabelVolume & m_Volume;
  /** What was taken from a cell may be within its box still. */
  std::vector<VoxelBox>              m_Boxes;
  std::vector<std::int32_t>          m_Characteristics;
  std::map<VertexId, HandleCut>      m_Records;
  std::map<std::size_t, VoxelChange> m_Given;
  /** Cells that need a cut that is too large, as they are. */
  std::set<VertexId> m_Scaffolds;
};

} // namespace

void
EulerGathering::Add(const CrowdedBlock & block)
{
  const VertexId    vertex = block.cells[0];
  const std::int8_t term = vertex != ExteriorVertex ? EulerTerm(block.cells) : 0;
  if (term != 0)
  {
    m_Sums[static_cast<std::size_t>(vertex)].fetch_add(term, std::memory_order_relaxed);
  }
}

std::vector<std::int32_t>
EulerGathering::GetCharacteristics() const
{
  return std::vector<std::int32_t>(m_Sums.begin(), m_Sums.end());
}

std::vector<std::int32_t>
FindEulerCharacteristics(const LabelVolume & volume, VertexId numberOfVertices, const Execution & execution)
{
  EulerGathering gathering(numberOfVertices);
  VisitVariedBlocks(
    volume, [&](std::size_t, const CrowdedBlock & block) { gathering.Add(block); }, execution);
  return gathering.GetCharacteristics();
}

HandleCuts
CutHandles(LabelVolume & volume, std::vector<std::int32_t> characteristics, std::vector<VoxelBox> boxes)
{
  Cutting cutting(volume, std::move(characteristics), std::move(boxes));
  for (int pass = 0; pass < MaximumNumberOfPasses; ++pass)
  {
    const std::vector<std::int32_t> ofPass = cutting.GetCharacteristics();
    for (VertexId v = ExteriorVertex + 1; v < static_cast<VertexId>(ofPass.size()); ++v)
    {
      if (ofPass[static_cast<std::size_t>(v)] != 1)
      {
        cutting.Cut(v);
      }
    }
  }
  return cutting.TakeResult();
}
} // namespace tissue
