/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CellSolids_h
#define CellSolids_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** \brief A connected volume of a cell, or of a void that the tissue encloses, as programs that mesh volumes take it:
 * by the closed surfaces around it. */
struct CellSolid
{
  /** ExteriorVertex for a void. */
  VertexId cell = ExteriorVertex;
  /** The walls of each surface, ascending: the outer one first, then those of the cavities and of the cells within. */
  std::vector<std::vector<WallId>> surfaces;
  double                           volume = 0.0;
  /** A point in the volume, halfway from the middle of a large triangle to what is opposite to it. */
  Point inside = { { 0.0, 0.0, 0.0 } };
};

/** What bounds which volume. */
struct CellSolids
{
  /** By cells, voids last. */
  std::vector<CellSolid> solids;
  /** Cells that have none, as their surface is not closed, ascending. */
  std::vector<VertexId> openCells;
};

/** Takes the surfaces of the cells apart, where they share no edge, and finds what each of them bounds. A cavity is in
 * the smallest solid of its cell whose box holds it. */
CellSolids
FindCellSolids(const WallMesh & mesh, std::size_t numberOfVertices);
} // namespace tissue

#endif
