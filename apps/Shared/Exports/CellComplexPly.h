/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CellComplexPly_h
#define CellComplexPly_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"
#include "TissueTessellationVTK/ProjectedData.h"

#include <string>

namespace tissue
{
/** The label as the 32 bits of a PLY's `int`. \throws std::runtime_error where it has more. */
std::int32_t
ToPlyLabel(Label label);

/** \brief Writes the walls as a PLY of cellcomplex (OpenAlea), as text: the elements `vertex` (x, y, z), `face`
 * (vertex_index, and `wall`, the WallId), `edge` (source, target, face_index: the faces at it) and `volume`
 * (face_index: the faces of a cell, label). Faces and volumes have the columns of numbers of `data`, too, with `_` for
 * what cannot be in a name. \throws std::runtime_error: a label of more than 32 bits, a file that cannot be written. */
void
WriteCellComplexPly(const WallMesh & mesh, const std::vector<Cell> & cells, const ProjectedData & data,
                    const std::string & path);
} // namespace tissue

#endif
