/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PageFile_h
#define PageFile_h

#include "Shared/Pictures/CellColors.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

class vtkTable;

namespace tissue
{
/** What a page shows. */
struct PageContent
{
  const WallMesh & walls;
  /** Row i is of the cell at vertex i + 1 of the adjacency complex: MakeCellTable, perhaps with names. */
  vtkTable * cells = nullptr;
  /** Of the vertices: ChooseCellColors. */
  const std::vector<Color> & colors;
  /** As in the report's file. */
  const nlohmann::ordered_json & report;
  /** Of lengths, in words; empty where it is not known. */
  std::string lengthUnit;
};

/** \brief What the page reads: one JSON object, in ASCII and without `<`, so that no text of a file can end the element
 * that it is in.
 *
 * - `unit`: symbol of the unit of lengths.
 * - `origin`: three numbers; `points`: their coordinates from there, three 32-bit floats each.
 * - `triangles`: three points each, unsigned 32-bit, those of a wall consecutive.
 * - `walls`: of each, the row of its first cell and of its second, counted from 1, where 0 is the exterior, and its
 *   number of triangles; unsigned 32-bit.
 * - `colors`: red, green and blue of each row, 8-bit.
 * - `columns`: `name`, `unit`, `kind`, `values` of each column of the cells (TableColumns.h). The kinds are `label`
 *   and `text`, lists of text; `count`, `category` and `flag`, lists of whole numbers; and `number`, 32-bit floats, not
 *   a number where it is not known.
 * - `report`.
 *
 * Arrays are little endian, in base64. \throws std::invalid_argument where the mesh, the cells and the colours are of
 * different numbers. */
std::string
MakePageData(const PageContent & content);

/** \brief Writes a page of HTML that shows the tissue by itself: it loads nothing, from the network or from files.
 *
 * It can be looked at in any browser of 2022 or later with WebGL 2. \throws std::runtime_error, and as MakePageData. */
void
WritePage(const PageContent & content, const std::string & path);
} // namespace tissue

#endif
