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
 * distance of a third of a voxel or so. Walls that the image has not are left out, and counted by their area. */
struct WallDistance
{
  /** Mean over all walls, in physical units; -1 where the image has none of them. */
  double mean = -1.0;
  /** Share of the area that is in walls which the image has not. */
  double shareOfFalseWalls = 0.0;
  /** Mean over the walls of each vertex, likewise. */
  std::vector<double> ofVertex;
  /** Edge of the cube of a voxel's volume. */
  double voxelLength = 1.0;

  /** A distance in voxels; -1 stays. */
  double
  InVoxels(double distance) const
  {
    return distance < 0.0 ? -1.0 : distance / voxelLength;
  }
};

/** `walls` has vertices below `numberOfVertices`, as `labels` has; larger ones are no cell's. */
WallDistance
MeasureWallDistance(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                    const Execution & execution = Execution());
} // namespace tissue

#endif
