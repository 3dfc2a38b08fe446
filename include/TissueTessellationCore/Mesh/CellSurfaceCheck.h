/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CellSurfaceCheck_h
#define TissueTessellationCore_CellSurfaceCheck_h

#include "TissueTessellationCore/Mesh/WallAngles.h"

#include <vector>

namespace tissue
{
/** \brief The surface of one cell: the triangles of all its walls, oriented outwards. */
struct CellSurface
{
  std::int32_t numberOfTriangles = 0;
  /** The number of the cell's walls that have a triangle. */
  std::int32_t numberOfWalls = 0;
  /** The number of parts of the surface that share no edge. Two parts that touch at a point alone are two. */
  std::int32_t numberOfComponents = 0;
  /** The number of points less that of edges plus that of triangles, which is 2 for a sphere. */
  std::int32_t eulerCharacteristic = 0;
  /** The number of edges in one triangle of the cell only, which are the rims of holes. */
  std::int32_t numberOfOpenEdges = 0;
  /** The number of edges in more than two triangles of the cell, where the surface touches itself. */
  std::int32_t numberOfCrowdedEdges = 0;
  /** The number of edges along which not as many of their triangles, two or more, run in one direction as in the other,
   * so that one of two is turned over, or a third one too many. */
  std::int32_t numberOfMisorientedEdges = 0;
  /** The volume within the surface. It is positive where the triangles face outwards, and has no meaning where the
   * surface is not closed. */
  double volume = 0.0;
  double area = 0.0;

  /** Tells whether as many of the triangles run along each edge in one direction as in the other, so that there is a
   * volume within. They are two, or more where the surface touches itself. Without triangles this is false. */
  bool
  IsClosed() const
  {
    return numberOfTriangles > 0 && numberOfOpenEdges == 0 && numberOfMisorientedEdges == 0;
  }

  /** Tells whether the surface is one topological sphere. One component by edges and the characteristic 2 leave no room
   * for a point where the surface touches itself. */
  bool
  IsSphere() const
  {
    return this->HasOnlySpheres() && numberOfComponents == 1;
  }

  /** Tells whether each component of the surface is a topological sphere, and no two of them touch: a sound cell has
   * one component more for each cell, or group of cells, within it, and for each further fragment. No component has
   * more than the characteristic 2. */
  bool
  HasOnlySpheres() const
  {
    return this->IsClosed() && numberOfCrowdedEdges == 0 && eulerCharacteristic == 2 * numberOfComponents;
  }
};

/** \brief What CheckCellSurfaces found: the promises of WallMesh, one by one. */
struct CellSurfaceCheck
{
  /** The least angles, and the edges. */
  WallAngles angles;
  /** The surface of each cell, by vertex of the adjacency complex. The entry of the exterior stays empty. */
  std::vector<CellSurface> cells;
  /** The cells that are in no triangle, in ascending order. */
  std::vector<VertexId> cellsWithoutTriangles;
  /** The cells with triangles whose surface does not consist of spheres, in ascending order. */
  std::vector<VertexId> cellsThatAreNoSphere;
  /** The points where by the triangles more than four cells meet, the exterior counted, in ascending order. */
  std::vector<PointId> crowdedPoints;
  /** The number of points whose WallMesh::numberOfCells is not that of their triangles; 0 where that list is empty. */
  std::int64_t numberOfMiscountedPoints = 0;
  /** The number of points that are in no triangle. */
  std::int64_t numberOfUnusedPoints = 0;
  /** The number of triangles with a repeated point, or with points that are collinear: the area is below 1e-12 of the
   * longest edge squared. */
  std::int64_t numberOfDegenerateTriangles = 0;

  /** Tells whether there is no fault of any kind. */
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
