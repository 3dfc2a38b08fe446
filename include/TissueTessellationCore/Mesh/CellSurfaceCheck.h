/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CellSurfaceCheck_h
#define TissueTessellationCore_CellSurfaceCheck_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The surface of one cell: the triangles of all its walls, oriented outwards. */
struct CellSurface
{
  std::int32_t numberOfTriangles = 0;
  /** Walls of the cell that have a triangle. */
  std::int32_t numberOfWalls = 0;
  /** Parts of the surface that share no edge; two parts that touch at a point are two. */
  std::int32_t numberOfComponents = 0;
  /** Points - edges + triangles; 2 for a sphere. */
  std::int32_t eulerCharacteristic = 0;
  /** Edges in one triangle of the cell: the rims of holes. */
  std::int32_t numberOfOpenEdges = 0;
  /** Edges in more than two triangles of the cell: the surface touches itself. */
  std::int32_t numberOfCrowdedEdges = 0;
  /** Edges whose two triangles run along them in the same direction: one of the two is turned over. */
  std::int32_t numberOfMisorientedEdges = 0;
  /** Signed, positive where the triangles face outwards; without a meaning where the surface is not closed. */
  double volume = 0.0;
  double area = 0.0;

  /** Each edge is in exactly two of the triangles, which run along it in opposite directions. False without triangles.
   */
  bool
  IsClosed() const
  {
    return numberOfTriangles > 0 && numberOfOpenEdges == 0 && numberOfCrowdedEdges == 0 &&
           numberOfMisorientedEdges == 0;
  }

  /** The surface is one topological sphere. (One component by edges and characteristic 2 leave no room for a point
   * where the surface touches itself.) */
  bool
  IsSphere() const
  {
    return this->IsClosed() && numberOfComponents == 1 && eulerCharacteristic == 2;
  }
};

/** \brief What CheckCellSurfaces found: the promises of WallMesh, one by one. */
struct CellSurfaceCheck
{
  /** By vertex of the adjacency complex; the entry of the exterior stays empty. */
  std::vector<CellSurface> cells;
  /** Cells that are in no triangle, ascending. */
  std::vector<VertexId> cellsWithoutTriangles;
  /** Cells with triangles whose surface is not a sphere, ascending. */
  std::vector<VertexId> cellsThatAreNoSphere;
  /** Points where more than four cells meet, the exterior counted, as the triangles have it; ascending. */
  std::vector<PointId> crowdedPoints;
  /** Points whose WallMesh::numberOfCells is not what the triangles have; 0 where that list is empty. */
  std::int64_t numberOfMiscountedPoints = 0;
  /** Points in no triangle. */
  std::int64_t numberOfUnusedPoints = 0;
  /** Triangles with a repeated point, or whose area is below 1e-12 of their longest edge squared (collinear points). */
  std::int64_t numberOfDegenerateTriangles = 0;

  /** No fault of any kind. */
  bool
  IsSound() const
  {
    return cellsWithoutTriangles.empty() && cellsThatAreNoSphere.empty() && crowdedPoints.empty() &&
           numberOfMiscountedPoints == 0 && numberOfUnusedPoints == 0 && numberOfDegenerateTriangles == 0;
  }
};

/** \brief Checks that each cell of a wall mesh is closed, and that no more than four meet at a point.
 *
 * `numberOfVertices` counts the cells and the exterior: the cells are the vertices 1 to numberOfVertices - 1.
 * Only the triangles and their walls are trusted, so that meshes of any origin can be judged; an empty
 * WallMesh::numberOfCells is taken as not given. Linear in the size of the mesh. Crossing triangles are not looked for.
 *
 * \throws std::invalid_argument as RequireConsistentIndices does. */
CellSurfaceCheck
CheckCellSurfaces(const WallMesh & mesh, VertexId numberOfVertices);
} // namespace tissue

#endif
