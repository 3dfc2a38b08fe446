/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_VolumeFitting_h
#define TissueTessellationCore_VolumeFitting_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{

/** \brief Moves all points by the least displacement that gives every cell its volume, to first order.
 *
 * A pressure in each cell moves its walls outwards; the pressures solve a sparse system by conjugate gradients. A
 * cell's volume changes by at most `largestShare` of the wanted one. `volumes` are by vertex; a cell whose wanted
 * volume is not positive keeps its own. \throws std::invalid_argument where more cells meet at a point than the mesh's
 * numberOfCells tells. */
void
FitVolumes(WallMesh & mesh, const std::vector<double> & volumes, double largestShare);
} // namespace tissue

#endif
