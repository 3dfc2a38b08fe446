/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaceUpdate.h"

#include "Nerve/KuhnWall.h"
#include "Nerve/WallPart.h"

#include <algorithm>
#include <unordered_map>

namespace tissue
{
namespace
{
VertexId
At(const LabelVolume & volume, const VoxelIndex & p)
{
  return volume.At(p[0], p[1], p[2]);
}

bool
IsBeforeInRaster(const VoxelIndex & a, const VoxelIndex & b)
{
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

/** Whether so many voxels have changed that the whole image is read sooner. */
bool
IsMuch(const LabelVolume & volume, const std::vector<VoxelChange> & changes)
{
  constexpr std::size_t share = 100;
  return changes.size() > volume.vertices.size() / share;
}

/** The first voxels of all blocks that one of the voxels is in, in raster order. */
std::vector<VoxelIndex>
FindBases(const std::vector<VoxelChange> & changes)
{
  std::vector<VoxelIndex> bases;
  bases.reserve(8 * changes.size());
  for (const VoxelChange & change : changes)
  {
    const VoxelIndex & p = change.voxel;
    for (int set = 0; set < 8; ++set)
    {
      bases.push_back({ { p[0] - (set & 1), p[1] - (set >> 1 & 1), p[2] - (set >> 2) } });
    }
  }
  std::sort(bases.begin(), bases.end(), IsBeforeInRaster);
  bases.erase(std::unique(bases.begin(), bases.end()), bases.end());
  return bases;
}

/** The face of a voxel towards the next one along an axis. */
struct VoxelFace
{
  VoxelIndex lower;
  int        axis;

  VoxelIndex
  Upper() const
  {
    VoxelIndex upper = lower;
    ++upper[axis];
    return upper;
  }

  std::array<std::int64_t, 3>
  TwiceCenter() const
  {
    std::array<std::int64_t, 3> twice{ { 2 * lower[0], 2 * lower[1], 2 * lower[2] } };
    ++twice[axis];
    return twice;
  }
};

bool
IsBeforeInRaster(const VoxelFace & a, const VoxelFace & b)
{
  return a.lower != b.lower ? IsBeforeInRaster(a.lower, b.lower) : a.axis < b.axis;
}

VertexPair
PairOf(VertexId a, VertexId b)
{
  return { { std::min(a, b), std::max(a, b) } };
}

/** The faces that have a voxel edge in common with one: three for each of its edges. */
std::array<VoxelFace, 12>
FacesAround(const VoxelFace & face)
{
  std::array<VoxelFace, 12> around;
  auto *                    next = around.data();
  for (int i = 1; i < 3; ++i)
  {
    const int  axis = (face.axis + i) % 3;
    VoxelIndex before = face.lower;
    VoxelIndex beforeUpper = face.Upper();
    *next++ = { before, axis };
    *next++ = { beforeUpper, axis };
    --before[axis];
    --beforeUpper[axis];
    *next++ = { before, axis };
    *next++ = { beforeUpper, axis };
    *next++ = { before, face.axis };
    before[axis] += 2;
    *next++ = { before, face.axis };
  }
  return around;
}

/** \brief The walls of the pairs of cells that have lost or got faces, found anew.
 *
 * What is left of a wall in several pieces has a changed face beside each of them; so the walls are flooded from the
 * faces that changed, from those around them, and from the first faces of the walls that there were. */
class WallUpdate
{
public:
  WallUpdate(const LabelVolume & volume, const std::vector<VoxelChange> & changes)
    : m_Volume(volume)
  {
    std::unordered_map<std::int64_t, VertexId> before;
    for (const VoxelChange & change : changes)
    {
      before.emplace(KeyOfVoxel(volume, change.voxel), change.before);
    }
    const auto beforeOf = [&](const VoxelIndex & p) {
      const auto at = before.find(KeyOfVoxel(volume, p));
      return at == before.end() ? At(volume, p) : at->second;
    };
    KeySet found;
    for (const VoxelChange & change : changes)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        VoxelIndex lower = change.voxel;
        --lower[axis];
        for (const VoxelFace & face : { VoxelFace{ lower, axis }, VoxelFace{ change.voxel, axis } })
        {
          if (found.Insert(this->KeyOf(face)))
          {
            m_Changed.push_back(face);
            this->AddConcerned(PairOf(beforeOf(face.lower), beforeOf(face.Upper())));
            this->AddConcerned(this->CellsOf(face));
          }
        }
      }
    }
    std::sort(m_Concerned.begin(), m_Concerned.end());
    m_Concerned.erase(std::unique(m_Concerned.begin(), m_Concerned.end()), m_Concerned.end());
  }

  void
  Run(std::vector<ImageWall> & walls)
  {
    const auto concerned = std::stable_partition(
      walls.begin(), walls.end(), [this](const ImageWall & wall) { return !this->IsConcerned(wall.cells); });
    std::vector<ImageWall> updated;
    for (auto wall = concerned; wall != walls.end(); ++wall)
    {
      const int axis = static_cast<int>(
        std::mismatch(wall->face[0].begin(), wall->face[0].end(), wall->face[1].begin()).first - wall->face[0].begin());
      this->AppendWall({ wall->face[0], axis }, updated);
    }
    for (const VoxelFace & face : m_Changed)
    {
      this->AppendWall(face, updated);
      for (const VoxelFace & beside : FacesAround(face))
      {
        this->AppendWall(beside, updated);
      }
    }
    std::sort(updated.begin(), updated.end(), ComesBefore);
    walls.erase(concerned, walls.end());
    const auto middle = static_cast<std::ptrdiff_t>(walls.size());
    walls.insert(walls.end(), updated.begin(), updated.end());
    std::inplace_merge(walls.begin(), walls.begin() + middle, walls.end(), ComesBefore);
  }

private:
  std::int64_t
  KeyOf(const VoxelFace & face) const
  {
    return 3 * KeyOfVoxel(m_Volume, face.lower) + face.axis;
  }

  VertexPair
  CellsOf(const VoxelFace & face) const
  {
    return PairOf(At(m_Volume, face.lower), At(m_Volume, face.Upper()));
  }

  void
  AddConcerned(const VertexPair & cells)
  {
    if (cells[0] != cells[1])
    {
      m_Concerned.push_back(cells);
    }
  }

  bool
  IsConcerned(const VertexPair & cells) const
  {
    return std::binary_search(m_Concerned.begin(), m_Concerned.end(), cells);
  }

  /** The wall that the face is of now, if that is concerned and new. */
  void
  AppendWall(const VoxelFace & start, std::vector<ImageWall> & walls)
  {
    WallPart part;
    part.cells = this->CellsOf(start);
    if (!this->IsConcerned(part.cells) || !m_Found.Insert(this->KeyOf(start)))
    {
      return;
    }
    VoxelFace              first = start;
    std::vector<VoxelFace> open{ start };
    while (!open.empty())
    {
      const VoxelFace face = open.back();
      open.pop_back();
      part.AddFace(face.TwiceCenter());
      first = IsBeforeInRaster(face, first) ? face : first;
      for (const VoxelFace & next : FacesAround(face))
      {
        if (this->CellsOf(next) == part.cells && m_Found.Insert(this->KeyOf(next)))
        {
          open.push_back(next);
        }
      }
    }
    part.first = first.TwiceCenter();
    walls.push_back(ToImageWall(m_Volume, part));
  }

  const LabelVolume &     m_Volume;
  std::vector<VoxelFace>  m_Changed;
  std::vector<VertexPair> m_Concerned;
  KeySet                  m_Found;
};
} // namespace

void
UpdateCrowdedBlocks(const LabelVolume & volume, const std::vector<VoxelChange> & changes,
                    std::vector<CrowdedBlock> & blocks)
{
  if (IsMuch(volume, changes))
  {
    blocks = FindCrowdedBlocks(volume);
    return;
  }
  const std::vector<VoxelIndex> bases = FindBases(changes);
  const auto                    isChanged = [&](const CrowdedBlock & block) {
    return std::binary_search(bases.begin(), bases.end(), block.base, [](const VoxelIndex & a, const VoxelIndex & b) {
      return IsBeforeInRaster(a, b);
    });
  };
  blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isChanged), blocks.end());
  const auto middle = static_cast<std::ptrdiff_t>(blocks.size());
  for (const VoxelIndex & base : bases)
  {
    CrowdedBlock block{ base, {} };
    for (int set = 0; set < 8; ++set)
    {
      block.cells[set] = volume.At(base[0] + (set & 1), base[1] + (set >> 1 & 1), base[2] + (set >> 2));
    }
    if (IsCrowded(block.cells))
    {
      blocks.push_back(block);
    }
  }
  std::inplace_merge(blocks.begin(),
                     blocks.begin() + middle,
                     blocks.end(),
                     [](const CrowdedBlock & a, const CrowdedBlock & b) { return IsBeforeInRaster(a.base, b.base); });
}

void
UpdateImageWalls(const LabelVolume & volume, const std::vector<VoxelChange> & changes, std::vector<ImageWall> & walls)
{
  if (IsMuch(volume, changes))
  {
    walls = FindImageWalls(volume);
    return;
  }
  WallUpdate(volume, changes).Run(walls);
}
} // namespace tissue
