/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PointJunctions_h
#define TissueTessellationCore_PointJunctions_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"

namespace tissue
{
/** \brief Makes the cells of a tissue of which the centres alone are known. The set has no walls and no junctions, and
 * its cells have no volumes.
 *
 * \param labels the labels of the cells, in ascending order; none may be the exterior's.
 * \throws std::invalid_argument for fewer than four points, numbers of points and labels that differ, labels that do
 * not ascend, one that is the exterior's, and coordinates that RequirePointRange() refuses. */
JunctionSet
MakePointJunctions(const std::vector<Point> & points, const std::vector<Label> & labels, Label exteriorLabel = 0);
} // namespace tissue

#endif
