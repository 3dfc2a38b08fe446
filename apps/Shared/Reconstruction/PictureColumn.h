/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PictureColumn_h
#define PictureColumn_h

#include "Shared/Pictures/ColorScale.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <optional>
#include <string>

class vtkTable;

namespace tissue
{
/** \brief The values of a column for a picture, by vertex, with its unit in the title.
 *
 * Nothing for `Label` and `Name`, which are different for all cells, and where there is no such column.
 * \param table of the cells, with a column `Label`. \param lengthUnit "µm". */
std::optional<PictureValues>
MakePictureValues(vtkTable * table, const std::string & column, const std::vector<Cell> & cells,
                  const std::string & lengthUnit);
} // namespace tissue

#endif
