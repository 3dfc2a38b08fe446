/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallDistance_h
#define TissueTessellationCore_WallDistance_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief How far the walls of a mesh are from the same walls in the image.
 *
 * The distance of a triangle is that of its centroid to the nearest centre of a voxel face between the same two cells;
 * means are weighted by the triangles' areas. As faces are met at their centres, a mesh on the very surface has a
 * distance of a third of a voxel or so. Walls that are missing in the image are left out, and counted by their area. */
struct WallDistance
{
  /** The mean distance of all walls, in physical units; -1 where the image has none of them. */
  double mean = -1.0;
  /** The share of the area that is in walls which are missing in the image. */
  double shareOfFalseWalls = 0.0;
  /** The other way round: the mean distance of the voxel faces between two cells to the nearest triangle between the
   * same two, in physical units; -1 where the mesh has none of them. */
  double meanFromImage = -1.0;
  /** The share of the faces that are in walls which are missing in the mesh, and left out. */
  double shareOfMissingWalls = 0.0;
  /** The Hausdorff distance at 95 %: that than which a twentieth of the mesh's area, or of the image's faces, is
   * farther off, whichever is more; in physical units; -1 where there is none. */
  double percentile95 = -1.0;
  /** The mean distance of each vertex's walls, in physical units; -1 where the image has none of them. */
  std::vector<double> ofVertex;
  /** The edge of a cube that has the volume of a voxel. */
  double voxelLength = 1.0;

  /** Turns a physical distance into one in voxels; -1 stays -1. */
  double
  InVoxels(double distance) const
  {
    return distance < 0.0 ? -1.0 : distance / voxelLength;
  }
};

/** Measures the distance of a mesh. The cells of `walls` and of `labels` are their vertices below `numberOfVertices`;
 * vertices from that one on are not cells.
 * \throws std::invalid_argument where the triangles of the mesh are not in the order of its walls. */
WallDistance
MeasureWallDistance(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                    const Execution & execution = Execution());
} // namespace tissue

#endif
