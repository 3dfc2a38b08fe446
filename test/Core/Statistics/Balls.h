/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef Balls_h
#define Balls_h

#include "Remeshing/WallRefinement.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

/** Round meshes of one cell. */
namespace tissue_test
{
using namespace tissue;

/** The unit ball, of 8 times 4^numberOfSplits triangles, as cell 1 with one wall to the exterior. */
inline WallMesh
UnitBall(int numberOfSplits)
{
  WallMesh mesh;
  mesh.points = { { { 1, 0, 0 } },  { { -1, 0, 0 } }, { { 0, 1, 0 } },
                  { { 0, -1, 0 } }, { { 0, 0, 1 } },  { { 0, 0, -1 } } };
  mesh.numberOfCells.assign(6, CellsWithinWall);
  mesh.triangles = { { { 0, 2, 4 } }, { { 2, 1, 4 } }, { { 1, 3, 4 } }, { { 3, 0, 4 } },
                     { { 2, 0, 5 } }, { { 1, 2, 5 } }, { { 3, 1, 5 } }, { { 0, 3, 5 } } };
  mesh.wallOfTriangle.assign(8, 0);
  mesh.walls = { { { { 1, ExteriorVertex } } } };
  for (int i = 0; i < numberOfSplits; ++i)
  {
    SplitTriangles(mesh);
    for (Point & p : mesh.points)
    {
      p = Normalized(p);
    }
  }
  return mesh;
}

/** The same, moved, stretched along three orthonormal axes. */
inline WallMesh
Ellipsoid(const Point & semiAxes, const std::array<Point, 3> & axes, const Point & center, int numberOfSplits = 4)
{
  WallMesh mesh = UnitBall(numberOfSplits);
  for (Point & p : mesh.points)
  {
    p = center + p[0] * semiAxes[0] * axes[0] + p[1] * semiAxes[1] * axes[1] + p[2] * semiAxes[2] * axes[2];
  }
  return mesh;
}
} // namespace tissue_test

#endif
