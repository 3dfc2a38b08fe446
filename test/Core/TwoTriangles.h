/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TwoTriangles_h
#define TwoTriangles_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue_test
{
using namespace tissue;

/** A triangle in the plane z = 0, and one that the z-axis runs along, lifted by a height. */
inline WallMesh
MakeTwoTriangles(double height)
{
  WallMesh mesh;
  mesh.points = { { { -2, -2, 0 } },        { { 2, -2, 0 } },           { { 0, 3, 0 } },
                  { { 0, 0, height - 1 } }, { { 0.5, 0, height + 1 } }, { { -0.5, 0, height + 1 } } };
  mesh.triangles = { { { 0, 1, 2 } }, { { 3, 4, 5 } } };
  mesh.wallOfTriangle = { 0, 1 };
  mesh.walls.resize(2);
  mesh.numberOfCells.assign(6, CellsWithinWall);
  return mesh;
}
} // namespace tissue_test

#endif
