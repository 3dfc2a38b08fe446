/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef GraphFile_h
#define GraphFile_h

#include <string>

class vtkTable;

namespace tissue
{
/** \brief Writes an undirected graph as GraphML (U. Brandes et al., GraphML Progress Report, GD 2001).
 *
 * The first column of the nodes is their id and an attribute, too; the first two of the edges are the ids of their
 * ends. All other columns (TableColumns.h) are attributes by their names: `long`, `double` or `string`; one that is not
 * known is left out. Throws std::runtime_error. */
void
WriteGraphML(vtkTable * nodes, vtkTable * edges, const std::string & path);
} // namespace tissue

#endif
