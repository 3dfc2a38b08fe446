/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_KuhnWall_h
#define TissueTessellationCore_KuhnWall_h

#include "Nerve/KeySet.h"
#include "Nerve/KuhnSimplex.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <optional>
#include <vector>

namespace tissue
{
/** The steps that lead from a voxel to its neighbours in the Kuhn subdivision: of 0 or 1 along each axis, the seven
 * ascending ones first, in the order of the sets of axes as bits, then their opposites in the same order. */
const std::array<VoxelIndex, 14> &
KuhnSteps();

inline VoxelIndex
operator+(const VoxelIndex & a, const VoxelIndex & b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

/** Where LabelVolume::vertices has a voxel of the image. */
inline std::size_t
OffsetOf(const LabelVolume & volume, const VoxelIndex & p)
{
  return (static_cast<std::size_t>(p[2]) * volume.size[1] + p[1]) * volume.size[0] + p[0];
}

/** A number of its own for each voxel of an image and for those outside that are not farther from it than two. */
std::int64_t
KeyOfVoxel(const LabelVolume & volume, const VoxelIndex & p);

/** An edge of the Kuhn subdivision. */
struct KuhnEdge
{
  VoxelIndex first;
  VoxelIndex second;
};

/** A triangle of the Kuhn subdivision: an edge, and a third voxel. */
struct KuhnTriangle
{
  KuhnEdge   edge;
  VoxelIndex third;
};

/** \brief A connected wall of two cells, as the label image has it as a piecewise linear map on the Kuhn subdivision of
 * its grid: a surface with a point on each edge, a segment in each triangle, a triangle or quadrilateral in each
 * tetrahedron that has both labels. Its boundary is closed lines, or lines from corner to corner. */
struct KuhnWall
{
  /** Of `start`, the first and the second. */
  VertexPair cells;
  KuhnEdge   start;
  /** By `cells`: the ends of the edges that the wall crosses, each as often as it is one. */
  std::array<std::vector<VoxelIndex>, 2> voxels;
  /** Circles of the boundary that have corners. */
  int numberOfCircles = 0;
  /** Circles of the boundary without a corner, each by an edge across the wall and a voxel of the third cell. */
  std::vector<KuhnTriangle> closedLines;

  /** Whether the wall is in the nerve as one edge, in the place of all of it: its boundary is one circle, with corners.
   * Handles of the wall are not looked at: the nerve has none. */
  bool
  IsSound() const
  {
    return numberOfCircles == 1 && closedLines.empty();
  }
};

/** \brief Finds walls, each once. Linear in what the walls cross. */
class KuhnWallSearch
{
public:
  /** The volume may not change while walls are sought. */
  explicit KuhnWallSearch(const LabelVolume & volume)
    : m_Volume(volume)
  {}

  /** The wall that an edge between two cells crosses; nothing where it has been found before. */
  std::optional<KuhnWall>
  Find(const KuhnEdge & start);

private:
  std::int64_t
  KeyOf(const KuhnEdge & edge) const;

  void
  Visit(const KuhnEdge & edge, KuhnWall & wall);

  void
  WalkCircle(const KuhnEdge & edge, const VoxelIndex & third, KuhnWall & wall);

  VertexId
  At(const VoxelIndex & voxel) const
  {
    return m_Volume.At(voxel[0], voxel[1], voxel[2]);
  }

  const LabelVolume & m_Volume;
  KeySet              m_Found;
  /** Of the wall in hand: edges to be visited, and the triangles at its boundary that walks have come through. */
  std::vector<KuhnEdge> m_Open;
  KeySet                m_Walked;
};
} // namespace tissue

#endif
