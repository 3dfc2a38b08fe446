/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_AngleMending_h
#define TissueTessellationCore_AngleMending_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallAngles.h"

namespace tissue
{
/** \brief Mends the places of a mesh that are sharper than some limits, by local moves: slivers, folds, wedges between
 * walls, and short edges.
 *
 * At each of them it tries, in this order: to flip an edge within a wall, to collapse a short edge within a wall or
 * along a line, and to move points. A change is made where what is around it gets less sharp in all, the sum of
 * limit / value - 1 over what is below its limit, and no more triangles cross than before. Corners are moved, but never
 * joined or taken away. What is not sharp stays where it is. The result is deterministic.
 *
 * Returns the number of places that are still sharper. Points keep their order; some may be gone. */
std::int64_t
MendAngles(WallMesh & mesh, const AngleLimits & limits, const Execution & execution = Execution());
} // namespace tissue

#endif
