/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_UnitedCell_h
#define TissueTessellationCore_UnitedCell_h

#include "Nerve/GeneralComplex.h"

#include <vector>

namespace tissue
{
/** Whether the surface that all vertices of one cell have together is one sphere or several: the dual of what leads
 * from them to other cells, by its Euler number.
 *
 * \param cellOf the cell of each vertex. */
bool
HasOnlySpheres(const GeneralComplex & complex, const std::vector<VertexId> & cellOf, VertexId cell);
} // namespace tissue

#endif
