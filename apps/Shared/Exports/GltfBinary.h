/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef GltfBinary_h
#define GltfBinary_h

#include "Shared/Exports/ExportedCells.h"

#include <string>

namespace tissue
{
/** Writes binary glTF 2.0 (`.glb`), with a node, a mesh and a material for each cell, see MeshExportEndings().
 * Positions are in single precision, from the middle of the tissue on. \throws std::runtime_error: no cells, more than
 * 4 GiB, a file that cannot be written. */
void
WriteGltfBinary(const std::vector<ExportedCell> & cells, const std::string & path);
} // namespace tissue

#endif
