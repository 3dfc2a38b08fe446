/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ExteriorTopology_h
#define TissueTessellationCore_ExteriorTopology_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief The topology of the boundary between the exterior and the cells: of a solid tissue a sphere, of a ring of
 * cells a torus, of a hollow tissue two spheres. */
struct SurfaceTopology
{
  /** Whether the surface has no rim, nowhere touches itself along a line, and is turned to one side: what follows is
   * known only then. Without triangles this is false. */
  bool isClosed = false;
  /** The number of its pieces, and the sum of their Euler characteristics. Where pieces touch in a point they are
   * apart, and so is a piece that touches itself in one. */
  std::int64_t numberOfPieces = 0;
  std::int64_t eulerCharacteristic = 0;

  /** The number of handles of all pieces; -1 where the surface is not closed. */
  std::int64_t
  Genus() const
  {
    return isClosed ? numberOfPieces - eulerCharacteristic / 2 : -1;
  }
};

/** The boundary in an image: that of the Freudenthal-Kuhn subdivision of the grid of voxel centres, a closed surface in
 * any image, without a point where it touches itself. Two voxels hang together where one has the other's index or one
 * more along each axis; what is outside of the image is exterior.
 * Planes are read in parallel; the cost is that of reading the image. */
SurfaceTopology
FindExteriorTopology(const LabelVolume & labels, const Execution & execution = Execution());

/** The boundary in a mesh: its triangles at the exterior. The indices must be consistent (RequireConsistentIndices). */
SurfaceTopology
FindExteriorTopology(const WallMesh & walls);
} // namespace tissue

#endif
