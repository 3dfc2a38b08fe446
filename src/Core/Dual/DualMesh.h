/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_DualMesh_h
#define TissueTessellationCore_DualMesh_h

#include "Nerve/GeneralComplex.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <functional>
#include <vector>

namespace tissue
{
class AdjacencyComplex;

/** \brief The dual of a complex (paper, section 4.2): a corner for each tetrahedron, a line for each triangle and a
 * polygonal wall for each edge. The polygons need not be plane. */
struct DualMesh
{
  /** Where three cells meet, from corner to corner. */
  struct Line
  {
    /** Indices of its corners. Other lines may have the same two. */
    std::array<PointId, 2> ends = { { 0, 0 } };
    /** Counterclockwise seen from the second end. */
    VertexTriple cells = { { 0, 0, 0 } };
    /** A point of the line between its ends. */
    Point middle = { { 0.0, 0.0, 0.0 } };
    /** Whether it is so bent that its middle is a point of the mesh in any case. */
    bool isBent = false;
  };

  struct Wall
  {
    /** The two cells, as in WallMesh: the smaller label first, and the exterior always second. */
    VertexPair cells = { { 0, 0 } };
    /** The indices of the corners, at least two, counterclockwise seen from the second cell. The first is the smallest
     * one. */
    std::vector<PointId> corners;
    /** The indices of the lines from each corner to the next. */
    std::vector<std::int32_t> lines;
  };

  std::vector<Point> corners;
  /** The four cells at each corner. */
  std::vector<VertexQuadruple> cellsOfCorner;
  std::vector<Line>            lines;
  /** The walls, ascending by the smaller, then by the larger vertex of each, then by their corners. */
  std::vector<Wall> walls;
};

/** How a line runs between its ends: see DualMesh::Line. */
struct LinePath
{
  Point middle;
  bool  isBent;
};

/** Gives the path of the line that a triangle of the complex stands for. */
using LinePathOf = std::function<LinePath(const Side & triangle)>;

/** Returns the dual of a complex whose ids are 0 ... NumberOfTetrahedra() - 1. The corners are given in their order.
 * \throws std::invalid_argument unless there is one for each. */
DualMesh
Dualize(const GeneralComplex & complex, std::vector<Point> corners, const LinePathOf & pathOf);

/** Returns the dual of a simplicial complex. The corners are given in the order of AdjacencyComplex::GetTetrahedra(),
 * lines are straight. */
DualMesh
Dualize(const AdjacencyComplex & complex, std::vector<Point> corners);

/** Swaps the cells of a wall, and turns its corners the other way round. */
void
TurnOver(DualMesh::Wall & wall);

/** \brief Divides each wall into triangles around a new point at the mean of its outline (paper, section 4.2): a star.
 *
 * Outlines are the corners, and the middles of lines that are bent, or have both ends in common with another: without
 * them the two were one. The points of the mesh are the corners, in their order, then these middles, then the walls'
 * centres, in the order of the walls. */
WallMesh
TriangulateAsStars(const DualMesh & dual);
} // namespace tissue

#endif
