/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SuspectCells_h
#define TissueTessellationCore_SuspectCells_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** Why a label may be no cell. */
enum class Suspicion
{
  /** On the border of the image, more than 8 times the median volume and not compact, or more than 32 times: a rest of
   * background, or many cells in one. Value: the volume over the median one. */
  Large,
  /** On the border of the image, more than 4 times the median volume, and at the exterior by three fifths of its
   * surface or more: a pocket of background. Value: the volume over the median one. */
  Pocket,
  /** More than a tenth of its voxels are apart from its largest piece, and the border of the image, which may cut a
   * curved cell in two, does not tell why. Value: that share. */
  Pieces
};

struct SuspectCell
{
  VertexId  cell;
  Suspicion suspicion;
  double    value;
};

/** \brief Finds labels of a segmented image that are probably no cells, in ascending order, each once.
 *
 * A cell is compact where 36 pi V^2 / A^3, which is 1 for a ball, is 0.4 or more, with two thirds of the area A of its
 * voxel faces, as that is half more than a curved surface has. A long cell, of 10 times its width, has 0.3: it is not
 * suspected unless it is large and the border cuts it. A tissue of fewer than 8 cells has no usual size, and no
 * suspects.
 */
std::vector<SuspectCell>
FindSuspectCells(const JunctionSet & junctions);
} // namespace tissue

#endif
