/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SeparateWalls_h
#define TissueTessellationCore_SeparateWalls_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <cstddef>

namespace tissue
{
/** The number of voxel faces from which on a piece of an interface counts as a wall; smaller ones are noise. */
constexpr std::int64_t LeastFacesOfSeparateWall = 10;

/** \brief The pairs of cells that have several walls, separate from each other; the exterior counts as a cell.
 *
 * In the image a wall is a piece of LeastFacesOfSeparateWall voxel faces or more that hang together by their edges, in
 * a mesh a piece of triangles that do, whatever walls the mesh calls them. */
struct SeparateWalls
{
  /** The pairs with two or more walls in the image. */
  std::size_t numberOfPairs = 0;
  /** Those of them that have as many walls in the mesh, or more. */
  std::size_t numberOfKeptPairs = 0;
};

/** The indices of the mesh must be consistent (RequireConsistentIndices). */
SeparateWalls
CountSeparateWalls(const WallMesh & walls, const LabelVolume & labels, const Execution & execution = Execution());
} // namespace tissue

#endif
