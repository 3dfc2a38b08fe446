/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SurfaceFiles_h
#define SurfaceFiles_h

#include "Shared/Exports/ExportedCells.h"

#include <string>

namespace tissue
{
/** Writes a PLY with the `label` of each vertex and face, as MorphoGraphX has it, as text.
 * \throws std::runtime_error: a label of more than 32 bits, a file that cannot be written. */
void
WriteFaceLabelPly(const std::vector<ExportedCell> & cells, const std::string & path);

/** Writes a Wavefront OBJ with a group `cell_L` for each cell. \throws std::runtime_error: it cannot be written. */
void
WriteWavefront(const std::vector<ExportedCell> & cells, const std::string & path);

/** Writes a binary STL. \throws std::runtime_error: it cannot be written. */
void
WriteStl(const std::vector<ExportedCell> & cells, const std::string & path);
} // namespace tissue

#endif
