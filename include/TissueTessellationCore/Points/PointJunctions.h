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
/** \brief The cells of a tissue of which the centres alone are known: without walls and junctions, and without volumes.
 *
 * \param labels of the cells, ascending; none is the exterior's.
 * \throws std::invalid_argument for fewer than four points, numbers of points and labels that differ, labels that do
 * not ascend, one that is the exterior's, and coordinates that RequirePointRange() refuses. */
JunctionSet
MakePointJunctions(const std::vector<Point> & points, const std::vector<Label> & labels, Label exteriorLabel = 0);
} // namespace tissue

#endif
