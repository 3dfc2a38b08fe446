/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WallMeshReader_h
#define WallMeshReader_h

#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"

#include <string>

namespace tissue
{
/** \brief Reads a wall mesh of any origin: a .vtp or .vtk file of triangles with a cell array of the two labels on each
 * one's sides, the normal pointing from the first to the second.
 *
 * \throws std::runtime_error: no such file, not readable, no triangles, other polygons, no such array, not of two
 * components or not of as many tuples as there are triangles, a label that is no whole number. */
TrianglesOfLabels
ReadWallMesh(const std::string & path, const std::string & labelArray);
} // namespace tissue

#endif
