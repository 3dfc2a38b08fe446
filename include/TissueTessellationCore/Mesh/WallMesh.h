/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallMesh_h
#define TissueTessellationCore_WallMesh_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** Numbers of cells, the exterior counted, that meet at a point of a wall mesh. */
constexpr std::uint8_t CellsWithinWall = 2;
constexpr std::uint8_t CellsOnLine = 3;
constexpr std::uint8_t CellsAtCorner = 4;

/** \brief A triangular mesh of all walls of a tissue, each wall once, shared by its two cells.
 *
 * - Every triangle belongs to one wall, and every wall separates two cells, or a cell and the exterior.
 * - A triangle's normal, by the right-hand rule, points from the wall's first cell to its second.
 * - The exterior is always the second; of two cells the one of the smaller label is the first.
 * - The triangles of all walls of a cell form a closed surface; a wall's own triangles form a disk.
 * - At most four cells (three and the exterior) meet at any point. */
struct WallMesh
{
  struct Wall
  {
    /** Vertices of the adjacency complex (indices of JunctionSet::cells), in the order of the class comment. */
    VertexPair cells = { { 0, 0 } };
  };

  std::vector<Point> points;
  /** Cells that meet at each point: CellsWithinWall, CellsOnLine (a triple line) or CellsAtCorner (a junction). */
  std::vector<std::uint8_t> numberOfCells;
  /** Point indices. */
  std::vector<Triangle> triangles;
  /** The wall of each triangle; triangles of a wall are consecutive. */
  std::vector<WallId> wallOfTriangle;
  std::vector<Wall>   walls;
};

/** The two cells of each wall. */
std::vector<VertexPair>
CellsOfWalls(const WallMesh & mesh);

/** \brief Makes sure that a wall mesh of any origin can be read without reaching outside of its lists.
 *
 * `numberOfVertices` counts the cells and the exterior, so it is at least 1. WallMesh::numberOfCells may be empty.
 *
 * \throws std::invalid_argument otherwise: for lists of different lengths, for a point, wall or cell that is out of
 * range, and for a wall of a cell with itself. */
void
RequireConsistentIndices(const WallMesh & mesh, VertexId numberOfVertices);
} // namespace tissue

#endif
