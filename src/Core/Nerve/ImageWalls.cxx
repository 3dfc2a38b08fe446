/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/PlaneScan.h"
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
/** Index of the part of a wall that a face belongs to; the first part is that of no faces. */
using FaceId = std::int32_t;
constexpr FaceId None = 0;

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

/** The parts that the faces at the upper sides of a voxel belong to, by axis. */
using FacesOfVoxel = std::array<FaceId, 3>;
constexpr FacesOfVoxel NoFaces{ { None, None, None } };

/** The faces of a voxel of a plane that has some. */
struct VoxelFaces
{
  std::uint32_t voxel;
  FacesOfVoxel  faces;
};

/** Ascending by the voxels: all others have no faces. */
using PlaneFaces = std::vector<VoxelFaces>;

FacesOfVoxel
FacesAt(const PlaneFaces & plane, std::size_t voxel)
{
  const auto at = std::lower_bound(
    plane.begin(), plane.end(), voxel, [](const VoxelFaces & f, std::size_t wanted) { return f.voxel < wanted; });
  return at != plane.end() && at->voxel == voxel ? at->faces : NoFaces;
}

/** The faces of all voxels of a row, to be found by their places in it. */
class FaceRow
{
public:
  explicit FaceRow(std::size_t width)
    : m_Faces(width, NoFaces)
    , m_Taken(width)
  {}

  const FacesOfVoxel &
  operator[](std::size_t x) const
  {
    return m_Faces[x];
  }

  /** For a change of a voxel that has had none. */
  FacesOfVoxel &
  Append(std::size_t x)
  {
    m_Taken[m_Count++] = static_cast<std::uint32_t>(x);
    return m_Faces[x];
  }

  void
  Clear()
  {
    for (std::size_t i = 0; i < m_Count; ++i)
    {
      m_Faces[m_Taken[i]] = NoFaces;
    }
    m_Count = 0;
  }

private:
  std::vector<FacesOfVoxel>  m_Faces;
  std::vector<std::uint32_t> m_Taken;
  std::size_t                m_Count = 0;
};

/** Faces around the edges of another one. */
using FacesAround = std::array<FaceId, 6>;

/** \brief Finds the walls within a slab of planes, and keeps the faces of its first and of its last plane: there the
 * next slabs go on.
 *
 * Each face is joined to those around its edges that come before it, which are six for each axis: every two faces
 * around a voxel edge are met when the later one comes. They are in the same row, in the row before, and in two rows of
 * the plane below: these are at hand, planes are kept as lists. */
class WallScan
{
public:
  /** \param visitBlock is called with the blocks of the slab in which there is something to know. */
  template <typename TVisitBlock>
  WallScan(const LabelVolume & volume, const Slab & slab, const TVisitBlock & visitBlock)
    : m_Width(static_cast<std::size_t>(volume.size[0]) + 2)
    , m_Row(m_Width)
    , m_RowBefore(m_Width)
    , m_RowBelow(m_Width)
    , m_RowBelowNext(m_Width)
  {
    this->AddPart({ { ExteriorVertex, ExteriorVertex } }, { { 0, 0, 0 } });
    PlaneScan scan(volume, slab.begin);
    for (std::int32_t z = slab.begin; z < slab.end; ++z)
    {
      if (z > slab.begin)
      {
        scan.Advance();
      }
      this->BeginPlane();
      scan.Visit([&](std::size_t p, const VoxelIndex & voxel) { this->AddFacesOfVoxel(scan, p, voxel); }, visitBlock);
      if (z == slab.begin)
      {
        m_First = m_Plane;
      }
    }
    m_Below = PlaneFaces();
    this->KeepWholeParts();
  }

  /** What hangs together within the slab is one part. */
  const std::vector<WallPart> &
  GetParts() const
  {
    return m_Parts;
  }
  const PlaneFaces &
  GetFirst() const
  {
    return m_First;
  }
  const PlaneFaces &
  GetLast() const
  {
    return m_Plane;
  }

private:
  void
  BeginPlane()
  {
    m_Below.swap(m_Plane);
    m_Plane.clear();
    m_NextBelow = 0;
    m_Y = -1;
    for (FaceRow * row : { &m_Row, &m_RowBefore, &m_RowBelow, &m_RowBelowNext })
    {
      row->Clear();
    }
    this->ReadRowBelow(0);
  }

  /** Becomes that of the next row, and of those below it. */
  void
  GoToRow(std::int32_t y)
  {
    for (; m_Y < y; ++m_Y)
    {
      std::swap(m_Row, m_RowBefore);
      m_Row.Clear();
      std::swap(m_RowBelow, m_RowBelowNext);
      m_RowBelowNext.Clear();
      this->ReadRowBelow(static_cast<std::size_t>(m_Y + 2));
    }
  }

  /** The next row of the plane below. */
  void
  ReadRowBelow(std::size_t y)
  {
    for (; m_NextBelow < m_Below.size() && m_Below[m_NextBelow].voxel < (y + 1) * m_Width; ++m_NextBelow)
    {
      m_RowBelowNext.Append(m_Below[m_NextBelow].voxel - y * m_Width) = m_Below[m_NextBelow].faces;
    }
  }

  /** Most faces need no new part: they get that of one around them that is of the same cells. Without branches for
   * each of these, which nothing would foretell. */
  FaceId
  AddFace(VertexId a, VertexId b, const FacesAround & around, const std::array<std::int64_t, 3> & center)
  {
    const VertexPair   cells{ { std::min(a, b), std::max(a, b) } };
    const std::int64_t key = KeyOf(cells);
    FaceId             face = None;
    for (std::size_t i = around.size(); i-- > 0;)
    {
      face = m_KeyOf[static_cast<std::size_t>(around[i])] == key ? around[i] : face;
    }
    if (face == None)
    {
      face = static_cast<FaceId>(m_Parts.size());
      this->AddPart(cells, center);
    }
    FaceId differences = 0;
    for (const FaceId other : around)
    {
      differences |= m_KeyOf[static_cast<std::size_t>(other)] == key ? other ^ face : 0;
    }
    if (differences != 0)
    {
      this->Join(face, around);
    }
    m_Parts[static_cast<std::size_t>(face)].AddFace(center);
    return face;
  }

  void
  Join(FaceId face, const FacesAround & around)
  {
    for (const FaceId other : around)
    {
      if (m_KeyOf[static_cast<std::size_t>(other)] == m_KeyOf[static_cast<std::size_t>(face)])
      {
        m_Sets.Unite(face, other);
      }
    }
  }

  void
  AddPart(const VertexPair & cells, const std::array<std::int64_t, 3> & firstCenter)
  {
    m_Sets.Add();
    m_KeyOf.push_back(KeyOf(cells));
    m_Parts.push_back({ cells, 0, { { 0, 0, 0 } }, firstCenter });
  }

  static std::int64_t
  KeyOf(const VertexPair & cells)
  {
    return std::int64_t{ cells[0] } << 32 | cells[1];
  }

  /** The faces at the upper sides of a voxel. Those before it exist in any case where it has one: the border of a plane
   * has none at its lower sides. */
  void
  AddFacesOfVoxel(const PlaneScan & scan, std::size_t p, const VoxelIndex & voxel)
  {
    this->GoToRow(voxel[1] + 1);
    const auto                        x = static_cast<std::size_t>(voxel[0] + 1);
    const std::array<VertexId, 4>     labels = scan.CellsAt(p);
    const std::array<std::int64_t, 3> twice{ { 2 * voxel[0], 2 * voxel[1], 2 * voxel[2] } };
    const FaceRow &                   row = m_Row;
    const FaceRow &                   before = m_RowBefore;
    const FacesOfVoxel &              below = m_RowBelow[x];
    FacesOfVoxel &                    faces = m_Row.Append(x);
    if (labels[1] != labels[0])
    {
      faces[0] =
        this->AddFace(labels[0],
                      labels[1],
                      { { before[x][0], before[x][1], before[x + 1][1], below[0], below[2], m_RowBelow[x + 1][2] } },
                      { { twice[0] + 1, twice[1], twice[2] } });
    }
    if (labels[2] != labels[0])
    {
      faces[1] = this->AddFace(labels[0],
                               labels[2],
                               { { row[x - 1][1], row[x - 1][0], faces[0], below[1], below[2], m_RowBelowNext[x][2] } },
                               { { twice[0], twice[1] + 1, twice[2] } });
    }
    if (labels[3] != labels[0])
    {
      faces[2] = this->AddFace(labels[0],
                               labels[3],
                               { { row[x - 1][2], before[x][2], faces[0], faces[1], row[x - 1][0], before[x][1] } },
                               { { twice[0], twice[1], twice[2] + 1 } });
    }
    m_Plane.push_back({ static_cast<std::uint32_t>(p), faces });
  }

  /** Makes one part of those that were joined, so that little is kept of many slabs. */
  void
  KeepWholeParts()
  {
    std::vector<FaceId>   rank(m_Parts.size(), None);
    std::vector<WallPart> whole;
    for (std::size_t i = 0; i < m_Parts.size(); ++i)
    {
      // A set's least part comes first, and is of the first face.
      const auto root = static_cast<std::size_t>(m_Sets.Find(static_cast<std::int64_t>(i)));
      if (root == i)
      {
        rank[i] = static_cast<FaceId>(whole.size());
        whole.push_back(m_Parts[i]);
      }
      else
      {
        rank[i] = rank[root];
        whole[static_cast<std::size_t>(rank[i])].AddFaces(m_Parts[i]);
      }
    }
    for (PlaneFaces * plane : { &m_First, &m_Plane })
    {
      for (VoxelFaces & voxel : *plane)
      {
        for (FaceId & face : voxel.faces)
        {
          face = rank[static_cast<std::size_t>(face)];
        }
      }
      plane->shrink_to_fit();
    }
    m_Parts.swap(whole);
    m_KeyOf = std::vector<std::int64_t>();
    m_Sets = DisjointSets();
  }

  std::size_t  m_Width;
  std::int32_t m_Y = 0;
  FaceRow      m_Row;
  FaceRow      m_RowBefore;
  FaceRow      m_RowBelow;
  FaceRow      m_RowBelowNext;
  PlaneFaces   m_First;
  PlaneFaces   m_Plane;
  PlaneFaces   m_Below;
  /** The first one below that is not yet in a row. */
  std::size_t           m_NextBelow = 0;
  std::vector<WallPart> m_Parts;
  /** The cells of the parts: every face asks for those of the faces around it. */
  std::vector<std::int64_t> m_KeyOf;
  DisjointSets              m_Sets;
};

/** The parts of the slabs so far, and what is joined of them. */
class WallJoin
{
public:
  /** \param width of a row with its border. */
  explicit WallJoin(std::size_t width)
    : m_Width(width)
  {}

  /** Appends the parts of the slab above the last one, and joins what goes on there. */
  void
  Append(const WallScan & scan)
  {
    const std::size_t lowerOffset = m_Offset;
    m_Offset = m_Parts.size();
    m_Parts.insert(m_Parts.end(), scan.GetParts().begin(), scan.GetParts().end());
    while (m_Sets.GetSize() < m_Parts.size())
    {
      m_Sets.Add();
    }
    for (const VoxelFaces & voxel : scan.GetFirst())
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        this->JoinFace(voxel, axis, lowerOffset);
      }
    }
    m_Below = scan.GetLast();
  }

  std::vector<ImageWall>
  TakeWalls(const LabelVolume & volume);

private:
  /** Joins a face to those around its lower edges that are below the plane. */
  void
  JoinFace(const VoxelFaces & voxel, int axis, std::size_t lowerOffset)
  {
    if (voxel.faces[axis] == None)
    {
      return;
    }
    const std::size_t  upper = m_Offset + static_cast<std::size_t>(voxel.faces[axis]);
    const FacesOfVoxel below = FacesAt(m_Below, voxel.voxel);
    const FacesOfVoxel beside = FacesAt(m_Below, voxel.voxel + (axis == 0 ? 1 : m_Width));
    for (const FaceId under : { below[axis], below[2], beside[2] })
    {
      const std::size_t lower = lowerOffset + static_cast<std::size_t>(under);
      if (under != None && AreEqual(m_Parts[upper].cells, m_Parts[lower].cells))
      {
        m_Sets.Unite(static_cast<std::int64_t>(upper), static_cast<std::int64_t>(lower));
      }
    }
  }

  std::size_t           m_Width;
  std::vector<WallPart> m_Parts;
  DisjointSets          m_Sets;
  /** Where the parts of the last slab begin, and the faces of its last plane. */
  std::size_t m_Offset = 0;
  PlaneFaces  m_Below;
};

std::vector<ImageWall>
WallJoin::TakeWalls(const LabelVolume & volume)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < m_Parts.size(); ++i)
  {
    // A set's least part comes first, and is of the first face.
    const auto root = static_cast<std::size_t>(m_Sets.Find(static_cast<std::int64_t>(i)));
    count += root == i ? 1 : 0;
    if (root != i)
    {
      m_Parts[root].AddFaces(m_Parts[i]);
      m_Parts[i].numberOfFaces = 0;
    }
  }
  std::vector<ImageWall> walls;
  walls.reserve(count);
  for (const WallPart & part : m_Parts)
  {
    if (part.numberOfFaces > 0)
    {
      walls.push_back(ToImageWall(volume, part));
    }
  }
  m_Parts = std::vector<WallPart>();
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
  return FindImageWalls(
    volume, [](std::size_t, const CrowdedBlock &) {}, execution);
}

std::vector<ImageWall>
FindImageWalls(const LabelVolume & volume, const BlockVisitor & visit, const Execution & execution)
{
  constexpr std::size_t   slabsAtOnce = 8;
  const std::vector<Slab> slabs = SlabsOf(volume);
  WallJoin                join(static_cast<std::size_t>(volume.size[0]) + 2);
  for (std::size_t first = 0; first < slabs.size(); first += slabsAtOnce)
  {
    std::vector<std::optional<WallScan>> scans(std::min(slabsAtOnce, slabs.size() - first));
    execution.For(scans.size(), [&](std::size_t i) {
      const std::size_t slab = first + i;
      scans[i].emplace(volume, slabs[slab], [&](const CrowdedBlock & block) { visit(slab, block); });
    });
    for (auto & scan : scans)
    {
      join.Append(*scan);
      scan.reset();
    }
  }
  return join.TakeWalls(volume);
}
} // namespace tissue
