/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/WallPart.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <tuple>

namespace tissue
{
namespace
{
using FaceId = std::int32_t;
constexpr FaceId None = -1;

/** The voxels at the sides of a face, by twice its centre: one coordinate is odd. */
std::array<VoxelIndex, 2>
SidesOf(const std::array<std::int64_t, 3> & twice)
{
  std::array<VoxelIndex, 2> sides;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isAcross = twice[axis] % 2 != 0;
    sides[0][axis] = static_cast<std::int32_t>((twice[axis] - (isAcross ? 1 : 0)) / 2);
    sides[1][axis] = sides[0][axis] + (isAcross ? 1 : 0);
  }
  return sides;
}

/** As by ==, which compilers make a call of that costs more than the comparison. */
bool
AreEqual(const VertexPair & a, const VertexPair & b)
{
  return a[0] == b[0] && a[1] == b[1];
}

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
    volume.vertices.Visit([&](const auto * first) {
      const auto * const row = first + (static_cast<std::size_t>(z) * volume.size[1] + y) * volume.size[0];
      std::copy(
        row, row + volume.size[0], plane.labels.begin() + (y + 1) * static_cast<std::ptrdiff_t>(plane.width) + 1);
    });
  }
  return plane;
}

/** The parts that the faces at the upper sides of a voxel belong to, by axis. */
using FacesOfVoxel = std::array<FaceId, 3>;
constexpr FacesOfVoxel NoFaces{ { None, None, None } };
/** Of all voxels of a plane. */
using PlaneFaces = std::vector<FacesOfVoxel>;

/** The faces of those voxels of a plane that have some. */
struct VoxelFaces
{
  std::uint32_t voxel;
  FacesOfVoxel  faces;
};

/** Faces around the edges of another one. */
using FacesAround = std::array<FaceId, 6>;

/** \brief Finds the walls within a slab of planes, and keeps the faces of its first and of its last plane: there the
 * next slabs go on.
 *
 * Each face is joined to those around its edges that come before it, which are six for each axis: every two faces
 * around a voxel edge are met when the later one comes. */
class WallScan
{
public:
  WallScan(const LabelVolume & volume, std::int32_t begin, std::int32_t end)
    : m_Plane(ReadPlane(volume, begin))
  {
    m_Below.assign(m_Plane.labels.size(), NoFaces);
    m_Last = m_Below;
    for (std::int32_t z = begin; z < end; ++z)
    {
      LabelPlane next = ReadPlane(volume, z + 1);
      std::swap(m_Below, m_Last);
      this->ClearLast();
      this->FindFaces(next, z);
      if (z == begin)
      {
        m_First = this->ListLast();
      }
      m_Plane = std::move(next);
    }
    m_LastList = this->ListLast();
    // Scans are kept until all are done: without their planes.
    m_Plane = {};
    m_Below = PlaneFaces();
    m_Last = PlaneFaces();
  }

  /** Faces around the lower edges of a face of a plane that are below the plane. */
  static std::array<FaceId, 3>
  Under(const PlaneFaces & below, int axis, std::size_t p, std::size_t width)
  {
    return { { below[p][axis], below[p][2], below[p + (axis == 0 ? 1 : width)][2] } };
  }

  const std::vector<WallPart> &
  GetParts() const
  {
    return m_Parts;
  }
  DisjointSets &
  GetSets()
  {
    return m_Sets;
  }
  const std::vector<VoxelFaces> &
  GetFirst() const
  {
    return m_First;
  }
  const std::vector<VoxelFaces> &
  GetLast() const
  {
    return m_LastList;
  }

private:
  /** Most faces need no new part: they get that of one around them that is of the same cells. */
  FaceId
  AddFace(VertexId a, VertexId b, const FacesAround & around, const std::array<std::int64_t, 3> & center)
  {
    const VertexPair cells{ { std::min(a, b), std::max(a, b) } };
    FaceId           face = None;
    for (const FaceId other : around)
    {
      if (other == None || other == face || !AreEqual(m_Parts[other].cells, cells))
      {
        continue;
      }
      if (face == None)
      {
        face = other;
      }
      else
      {
        m_Sets.Unite(face, other);
      }
    }
    if (face == None)
    {
      face = static_cast<FaceId>(m_Sets.Add());
      m_Parts.push_back({ cells, 0, { { 0, 0, 0 } }, center });
    }
    m_Parts[face].AddFace(center);
    return face;
  }

  /** Whether voxels of a plane have no faces at their upper sides, as nearly everywhere. */
  bool
  HaveNoFaces(const LabelPlane & next, std::size_t begin, std::size_t end) const
  {
    const VertexId * labels = m_Plane.labels.data();
    const VertexId * behind = labels + m_Plane.width;
    const VertexId * above = next.labels.data();
    VertexId         differences = 0;
    for (std::size_t p = begin; p < end; ++p)
    {
      differences |= (labels[p] ^ labels[p + 1]) | (labels[p] ^ behind[p]) | (labels[p] ^ above[p]);
    }
    return differences == 0;
  }

  void
  FindFaces(const LabelPlane & next, std::int32_t z)
  {
    constexpr std::int32_t stretch = 16;
    const auto             width = static_cast<std::size_t>(m_Plane.width);
    for (std::int32_t y = 0; y + 1 < m_Plane.height; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(y) * width;
      for (std::int32_t begin = 0; begin + 1 < m_Plane.width; begin += stretch)
      {
        const std::int32_t end = std::min(begin + stretch, m_Plane.width - 1);
        if (!this->HaveNoFaces(next, row + static_cast<std::size_t>(begin), row + static_cast<std::size_t>(end)))
        {
          for (std::int32_t x = begin; x < end; ++x)
          {
            this->AddFacesOfVoxel(next, row + static_cast<std::size_t>(x), { { 2 * (x - 1), 2 * (y - 1), 2 * z } });
          }
        }
      }
    }
  }

  /** The faces at the upper sides of a voxel. Those before it exist in any case where it has one: the border of a plane
   * has none at its lower sides. */
  void
  AddFacesOfVoxel(const LabelPlane & next, std::size_t p, const std::array<std::int64_t, 3> & twice)
  {
    const std::size_t             width = static_cast<std::size_t>(m_Plane.width);
    const std::array<VertexId, 4> labels{
      { m_Plane.labels[p], m_Plane.labels[p + 1], m_Plane.labels[p + width], next.labels[p] }
    };
    if (labels[1] == labels[0] && labels[2] == labels[0] && labels[3] == labels[0])
    {
      return;
    }
    const auto & last = m_Last;
    m_Touched.push_back(p);
    if (labels[1] != labels[0])
    {
      const auto under = Under(m_Below, 0, p, width);
      m_Last[p][0] = this->AddFace(
        labels[0],
        labels[1],
        { { last[p - width][0], last[p - width][1], last[p - width + 1][1], under[0], under[1], under[2] } },
        { { twice[0] + 1, twice[1], twice[2] } });
    }
    if (labels[2] != labels[0])
    {
      const auto under = Under(m_Below, 1, p, width);
      m_Last[p][1] = this->AddFace(labels[0],
                                   labels[2],
                                   { { last[p - 1][1], last[p - 1][0], last[p][0], under[0], under[1], under[2] } },
                                   { { twice[0], twice[1] + 1, twice[2] } });
    }
    if (labels[3] != labels[0])
    {
      m_Last[p][2] = this->AddFace(
        labels[0],
        labels[3],
        { { last[p - 1][2], last[p - width][2], last[p][0], last[p][1], last[p - 1][0], last[p - width][1] } },
        { { twice[0], twice[1], twice[2] + 1 } });
    }
  }

  std::vector<VoxelFaces>
  ListLast() const
  {
    std::vector<VoxelFaces> list;
    list.reserve(m_Touched.size());
    for (const std::size_t p : m_Touched)
    {
      list.push_back({ static_cast<std::uint32_t>(p), m_Last[p] });
    }
    return list;
  }

  /** Takes out the faces of the plane before the one below, whose memory is used again. */
  void
  ClearLast()
  {
    for (const std::size_t p : m_TouchedBelow)
    {
      m_Last[p] = NoFaces;
    }
    m_TouchedBelow.swap(m_Touched);
    m_Touched.clear();
  }

  LabelPlane               m_Plane;
  std::vector<VoxelFaces>  m_First;
  std::vector<VoxelFaces>  m_LastList;
  PlaneFaces               m_Below;
  PlaneFaces               m_Last;
  std::vector<std::size_t> m_Touched;
  std::vector<std::size_t> m_TouchedBelow;
  std::vector<WallPart>    m_Parts;
  DisjointSets             m_Sets;
};

/** The parts of the slabs so far, and what is joined of them. */
class WallJoin
{
public:
  /** \param planeSize voxels of a plane with its border. */
  explicit WallJoin(std::size_t planeSize)
    : m_Below(planeSize, NoFaces)
  {}

  void
  Append(WallScan & scan)
  {
    m_Offset = m_Parts.size();
    m_Parts.insert(m_Parts.end(), scan.GetParts().begin(), scan.GetParts().end());
    for (std::size_t k = 0; k < scan.GetParts().size(); ++k)
    {
      m_Sets.Add();
      m_Sets.Unite(this->Index(k), this->Index(static_cast<std::size_t>(scan.GetSets().Find(static_cast<FaceId>(k)))));
    }
  }

  /** Joins the first plane of the slab that was appended last to the last one of that before, whose parts begin at
   * lowerOffset. */
  void
  JoinSlabs(const std::vector<VoxelFaces> & below, const std::vector<VoxelFaces> & first, std::size_t lowerOffset,
            std::size_t width)
  {
    for (const VoxelFaces & voxel : below)
    {
      m_Below[voxel.voxel] = voxel.faces;
    }
    for (const VoxelFaces & voxel : first)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        this->JoinFace(voxel.faces[axis], WallScan::Under(m_Below, axis, voxel.voxel, width), lowerOffset);
      }
    }
    for (const VoxelFaces & voxel : below)
    {
      m_Below[voxel.voxel] = NoFaces;
    }
  }

  std::size_t
  GetOffset() const
  {
    return m_Offset;
  }

  std::vector<ImageWall>
  GatherWalls(const LabelVolume & volume);

private:
  void
  JoinFace(FaceId face, const std::array<FaceId, 3> & facesUnder, std::size_t lowerOffset)
  {
    for (const FaceId under : facesUnder)
    {
      if (face != None && under != None)
      {
        const std::size_t upper = m_Offset + static_cast<std::size_t>(face);
        const std::size_t lower = lowerOffset + static_cast<std::size_t>(under);
        if (AreEqual(m_Parts[upper].cells, m_Parts[lower].cells))
        {
          m_Sets.Unite(static_cast<std::int64_t>(upper), static_cast<std::int64_t>(lower));
        }
      }
    }
  }

  std::int64_t
  Index(std::size_t part) const
  {
    return static_cast<std::int64_t>(m_Offset + part);
  }

  std::vector<WallPart> m_Parts;
  DisjointSets          m_Sets;
  std::size_t           m_Offset = 0;
  /** The faces of the plane below a slab that is being joined; else none. */
  PlaneFaces m_Below;
};

std::vector<ImageWall>
WallJoin::GatherWalls(const LabelVolume & volume)
{
  std::vector<WallPart> joined(m_Parts.size());
  for (std::size_t i = 0; i < m_Parts.size(); ++i)
  {
    WallPart & whole = joined[static_cast<std::size_t>(m_Sets.Find(static_cast<std::int64_t>(i)))];
    if (whole.numberOfFaces == 0)
    {
      // A set's least part comes first here, and is of the first face.
      whole.cells = m_Parts[i].cells;
      whole.first = m_Parts[i].first;
    }
    whole.numberOfFaces += m_Parts[i].numberOfFaces;
    std::transform(whole.sum.begin(), whole.sum.end(), m_Parts[i].sum.begin(), whole.sum.begin(), std::plus<>());
  }
  std::vector<ImageWall> walls;
  for (const WallPart & part : joined)
  {
    if (part.numberOfFaces > 0)
    {
      walls.push_back(ToImageWall(volume, part));
    }
  }
  std::sort(walls.begin(), walls.end(), ComesBefore);
  return walls;
}
} // namespace

ImageWall
ToImageWall(const LabelVolume & volume, const WallPart & part)
{
  const double half = 0.5 / static_cast<double>(part.numberOfFaces);
  return { part.cells,
           part.numberOfFaces,
           volume.ToPhysical({ { half * static_cast<double>(part.sum[0]),
                                 half * static_cast<double>(part.sum[1]),
                                 half * static_cast<double>(part.sum[2]) } }),
           SidesOf(part.first) };
}

bool
ComesBefore(const ImageWall & a, const ImageWall & b)
{
  const auto rank = [](const ImageWall & wall) {
    const auto & [p, q] = wall.face;
    return std::make_tuple(wall.cells, -wall.numberOfFaces, p[2], p[1], p[0], q[2], q[1], q[0]);
  };
  return rank(a) < rank(b);
}

std::vector<ImageWall>
FindImageWalls(const LabelVolume & volume, const Execution & execution)
{
  // Planes of a slab: few slabs, as each keeps two planes of faces, and yet one for each of many threads.
  constexpr std::int32_t  planesPerSlab = 32;
  constexpr std::size_t   slabsAtOnce = 8;
  const std::int32_t      planes = volume.size[2] + 1;
  const auto              count = static_cast<std::size_t>((planes + planesPerSlab - 1) / planesPerSlab);
  const std::size_t       width = static_cast<std::size_t>(volume.size[0]) + 2;
  WallJoin                join(width * (static_cast<std::size_t>(volume.size[1]) + 2));
  std::vector<VoxelFaces> below;
  for (std::size_t first = 0; first < count; first += slabsAtOnce)
  {
    std::vector<std::optional<WallScan>> scans(std::min(slabsAtOnce, count - first));
    execution.For(scans.size(), [&](std::size_t i) {
      const auto begin = static_cast<std::int32_t>(first + i) * planesPerSlab - 1;
      scans[i].emplace(volume, begin, std::min(begin + planesPerSlab, volume.size[2]));
    });
    for (auto & scan : scans)
    {
      const std::size_t lowerOffset = join.GetOffset();
      join.Append(*scan);
      join.JoinSlabs(below, scan->GetFirst(), lowerOffset, width);
      below = scan->GetLast();
      scan.reset();
    }
  }
  return join.GatherWalls(volume);
}
} // namespace tissue
