/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/ImageNerve.h"

#include "Geometry/SpatialOrder.h"

#include <algorithm>
#include <atomic>
#include <tuple>

namespace tissue
{
namespace
{
/** A tetrahedron of the subdivision with four labels, ordered by its place in the image. */
struct Corner
{
  KuhnSimplex::Key key;

  auto
  Rank() const
  {
    return std::make_tuple(key.base[2], key.base[1], key.base[0], key.first, key.second);
  }

  KuhnSimplex
  GetSimplex() const
  {
    return KuhnSimplex::FromWay(key.base, key.first, key.second);
  }
};

using Labels = std::array<VertexId, 4>;

bool
AreDifferent(const Labels & l)
{
  return l[0] != l[1] && l[0] != l[2] && l[0] != l[3] && l[1] != l[2] && l[1] != l[3] && l[2] != l[3];
}

Labels
LabelsOf(const LabelVolume & volume, const KuhnSimplex & simplex)
{
  Labels labels;
  for (int i = 0; i < 4; ++i)
  {
    labels[i] = volume.At(simplex.voxels[i][0], simplex.voxels[i][1], simplex.voxels[i][2]);
  }
  return labels;
}

/** The corners in ascending order of their ranks, as the blocks are. */
std::vector<Corner>
FindCorners(const std::vector<CrowdedBlock> & blocks)
{
  std::vector<Corner> corners;
  for (const CrowdedBlock & block : blocks)
  {
    for (int first = 0; first < 3; ++first)
    {
      for (int second = 0; second < 3; ++second)
      {
        const int atFirst = 1 << first;
        if (second != first &&
            AreDifferent(
              { { block.cells[0], block.cells[atFirst], block.cells[atFirst | 1 << second], block.cells[7] } }))
        {
          corners.push_back({ { block.base, first, second } });
        }
      }
    }
  }
  return corners;
}

/** \brief A walk along a line of the image, from triangle to triangle of the subdivision. */
class LineWalk
{
public:
  /** From a corner through the triangle opposite to its vertex i. */
  LineWalk(const LabelVolume & volume, const KuhnSimplex & simplex, int i)
    : m_Volume(volume)
    , m_Simplex(simplex)
    , m_Labels(LabelsOf(volume, simplex))
    , m_Exit(i)
  {}

  /** Goes through the triangle ahead. Returns false where the tetrahedron behind it is a corner. */
  bool
  Step()
  {
    m_Simplex.Pivot(m_Exit);
    const VoxelIndex & voxel = m_Simplex.voxels[m_Exit];
    const VertexId     label = m_Volume.At(voxel[0], voxel[1], voxel[2]);
    m_Labels[m_Exit] = label;
    for (int j = 0; j < 4; ++j)
    {
      // Two vertices of one label: the line leaves through the triangle that the earlier of them is not in.
      if (j != m_Exit && m_Labels[j] == label)
      {
        m_Exit = j;
        return true;
      }
    }
    return false;
  }

  const KuhnSimplex &
  GetSimplex() const
  {
    return m_Simplex;
  }

  /** At a corner: the label that the line has not. */
  VertexId
  GetFourthLabel() const
  {
    return m_Labels[m_Exit];
  }

  /** The middle of the triangle ahead, as a continuous index. */
  Point
  GetPlace() const
  {
    Point sum{ { 0.0, 0.0, 0.0 } };
    for (int i = 0; i < 4; ++i)
    {
      for (int axis = 0; i != m_Exit && axis < 3; ++axis)
      {
        sum[axis] += m_Simplex.voxels[i][axis];
      }
    }
    return (1.0 / 3.0) * sum;
  }

private:
  const LabelVolume & m_Volume;
  KuhnSimplex         m_Simplex;
  Labels              m_Labels;
  int                 m_Exit;
};

/** The other end of a line that leaves a corner: the corner, and the vertex of its simplex that the line has not. */
struct LineEnd
{
  std::int32_t corner = 0;
  std::int32_t vertex = 0;
};

/** A walk to the other end; the path is each place that it comes through. */
LineEnd
FollowLine(const LabelVolume & volume, const std::vector<Corner> & corners, LineWalk walk, std::vector<LineWalk> & path)
{
  do
  {
    path.push_back(walk);
  } while (walk.Step());
  const Corner end{ walk.GetSimplex().GetKey() };
  const auto   at = std::lower_bound(
    corners.begin(), corners.end(), end, [](const Corner & a, const Corner & b) { return a.Rank() < b.Rank(); });
  const Labels labels = LabelsOf(volume, at->GetSimplex());
  return { static_cast<std::int32_t>(at - corners.begin()),
           static_cast<std::int32_t>(std::find(labels.begin(), labels.end(), walk.GetFourthLabel()) - labels.begin()) };
}

ImageLine
MeasureLine(const LabelVolume & volume, const std::vector<LineWalk> & path)
{
  // Six tetrahedra fill a cube, so this is two or three voxels: enough to smooth the zigzag of the path.
  constexpr std::size_t stride = 12;
  Point                 last = volume.ToPhysical(path.front().GetPlace());
  ImageLine             line{ volume.ToPhysical(path[path.size() / 2].GetPlace()), 0.0 };
  const auto            goTo = [&](std::size_t step) {
    const Point place = volume.ToPhysical(path[step].GetPlace());
    line.length += Distance(last, place);
    last = place;
  };
  for (std::size_t step = stride - 1; step + 1 < path.size(); step += stride)
  {
    goTo(step);
  }
  goTo(path.size() - 1);
  return line;
}

/** The way of a corner is positively oriented, in physical space, if its axes are. */
bool
IsPositive(const LabelVolume & volume, const KuhnSimplex::Key & key)
{
  const bool areAxesEven = (key.second - key.first + 3) % 3 == 1;
  return areAxesEven == (Dot(volume.steps[0], Cross(volume.steps[1], volume.steps[2])) > 0.0);
}

/** The mean of the four voxels, as a continuous index. */
Point
PlaceOf(const Corner & corner)
{
  Point sum{ { 0.0, 0.0, 0.0 } };
  for (const VoxelIndex & voxel : corner.GetSimplex().voxels)
  {
    sum =
      sum + Point{ { static_cast<double>(voxel[0]), static_cast<double>(voxel[1]), static_cast<double>(voxel[2]) } };
  }
  return 0.25 * sum;
}

void
AddCorner(const LabelVolume & volume, const Corner & corner, ImageNerve & nerve)
{
  const KuhnSimplex simplex = corner.GetSimplex();
  Labels            labels = LabelsOf(volume, simplex);
  if (!IsPositive(volume, corner.key))
  {
    std::swap(labels[2], labels[3]);
  }
  nerve.complex.Add(labels, static_cast<CornerId>(nerve.corners.size()));
  nerve.corners.push_back(volume.ToPhysical(PlaceOf(corner)));
}

/** Glues each line's ends, the lines in the order of their first ends. */
void
GlueLines(const LabelVolume & volume, const std::vector<Corner> & corners, const std::vector<LineEnd> & ends,
          GeneralComplex & complex)
{
  const auto sideOf = [&](std::size_t corner, int vertex) {
    const auto id = static_cast<TetrahedronId>(corner);
    return Side{
      id, LocalIndex(complex.GetTetrahedron(id).vertices, LabelsOf(volume, corners[corner].GetSimplex())[vertex])
    };
  };
  LineId line = 0;
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      const LineEnd & end = ends[4 * c + i];
      if (static_cast<std::size_t>(end.corner) > c)
      {
        complex.Glue(sideOf(c, i), sideOf(static_cast<std::size_t>(end.corner), end.vertex), line++);
      }
    }
  }
}

/** Moves and links ask for what is near a tetrahedron: where that is near in memory they take no longer for a large
 * image than for a small one. The order is by voxels, so that it is the same for an image that is turned in space. */
std::vector<TetrahedronId>
OrderInImage(const std::vector<Corner> & corners)
{
  std::vector<Point> places(corners.size());
  std::transform(corners.begin(), corners.end(), places.begin(), PlaceOf);
  return HilbertOrder(places);
}

/** Corners of one task: enough that handing it out costs nothing. */
constexpr std::size_t ChunkSize = 1024;
} // namespace

ImageNerve
MakeImageNerve(const LabelVolume & volume, VertexId numberOfVertices, const std::vector<CrowdedBlock> & blocks,
               const Execution & execution)
{
  const std::vector<Corner> corners = FindCorners(blocks);
  ImageNerve                nerve{ GeneralComplex(numberOfVertices), {}, {} };
  nerve.complex.Reserve(corners.size());
  nerve.corners.reserve(corners.size());
  for (const Corner & corner : corners)
  {
    AddCorner(volume, corner, nerve);
  }
  // Each line is followed and measured from its first end. Tasks know of the line only when another one has followed
  // it: where it has not, they follow it for nothing.
  std::vector<LineEnd>                   ends(4 * corners.size());
  std::vector<std::atomic<std::uint8_t>> isSecondEnd(ends.size());
  std::vector<std::vector<ImageLine>>    lines((corners.size() + ChunkSize - 1) / ChunkSize);
  execution.For(lines.size(), [&](std::size_t chunk) {
    std::vector<LineWalk> path;
    for (std::size_t c = chunk * ChunkSize; c < std::min(corners.size(), (chunk + 1) * ChunkSize); ++c)
    {
      const KuhnSimplex simplex = corners[c].GetSimplex();
      for (int i = 0; i < 4; ++i)
      {
        if (isSecondEnd[4 * c + i].load(std::memory_order_relaxed) != 0)
        {
          continue;
        }
        path.clear();
        const LineEnd end = FollowLine(volume, corners, LineWalk(volume, simplex, i), path);
        if (static_cast<std::size_t>(end.corner) > c)
        {
          ends[4 * c + i] = end;
          isSecondEnd[4 * static_cast<std::size_t>(end.corner) + end.vertex].store(1, std::memory_order_relaxed);
          lines[chunk].push_back(MeasureLine(volume, path));
        }
      }
    }
  });
  GlueLines(volume, corners, ends, nerve.complex);
  nerve.complex = nerve.complex.InOrder(OrderInImage(corners));
  nerve.lines.reserve(2 * corners.size());
  for (std::vector<ImageLine> & ofChunk : lines)
  {
    nerve.lines.insert(nerve.lines.end(), ofChunk.begin(), ofChunk.end());
    ofChunk = std::vector<ImageLine>();
  }
  return nerve;
}
} // namespace tissue
