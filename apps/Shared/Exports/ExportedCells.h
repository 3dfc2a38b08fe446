/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ExportedCells_h
#define ExportedCells_h

#include "Shared/Pictures/CellColors.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** The closed surface of a cell, by points of its own. */
struct ExportedCell
{
  Label              label = 0;
  Color              color = { { 0, 0, 0 } };
  std::vector<Point> points;
  /** Indices of these; outwards. */
  std::vector<Triangle> triangles;
};

/** The surfaces of the cells of some labels, or of all where there are none, in the order of the cells. Those without
 * triangles are left out. \throws std::runtime_error that names a label that no cell has. */
std::vector<ExportedCell>
CollectExportedCells(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels);
} // namespace tissue

#endif
