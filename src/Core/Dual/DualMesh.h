/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_DualMesh_h
#define TissueTessellationCore_DualMesh_h

#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The dual of an adjacency complex (paper, section 4.2): a corner for each tetrahedron and a polygonal wall for
 * each edge. The polygons need not be plane. */
struct DualMesh
{
  struct Wall
  {
    /** The two cells, as in WallMesh: the smaller label first, and the exterior always second. */
    VertexPair cells = { { 0, 0 } };
    /** The indices of the corners, at least three, counterclockwise seen from the second cell. */
    std::vector<PointId> corners;
  };

  std::vector<Point> corners;
  /** The walls, ascending by the smaller, then by the larger vertex of each. */
  std::vector<Wall> walls;
};

/** Returns the dual of a complex. The corners are given in the order of AdjacencyComplex::GetTetrahedra(). */
DualMesh
Dualize(const AdjacencyComplex & complex, std::vector<Point> corners);

/** \brief Divides each wall into triangles around a new point at the mean of its corners (paper, section 4.2): a star.
 *
 * The points of the mesh are the corners, in their order, and then the walls' centres, in that of the walls. */
WallMesh
TriangulateAsStars(const DualMesh & dual);
} // namespace tissue

#endif
