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
/** \brief The dual of an adjacency complex (paper, section 4.2): a corner for each tetrahedron, a polygonal wall for
 * each edge. Polygons need not be plane. */
struct DualMesh
{
  struct Wall
  {
    /** As in WallMesh: the smaller label first, the exterior second. */
    VertexPair cells = { { 0, 0 } };
    /** Corner indices, counterclockwise seen from the second cell; at least 3. */
    std::vector<PointId> corners;
  };

  std::vector<Point> corners;
  /** Ascending by the smaller, then by the larger vertex. */
  std::vector<Wall> walls;
};

/** `corners` are in the order of AdjacencyComplex::GetTetrahedra(). */
DualMesh
Dualize(const AdjacencyComplex & complex, std::vector<Point> corners);

/** \brief Triangles for the polygons: each wall is a star around a new point at the mean of its corners (section 4.2).
 *
 * Points: the corners first, in their order, then the walls' centres, in theirs. */
WallMesh
TriangulateAsStars(const DualMesh & dual);
} // namespace tissue

#endif
