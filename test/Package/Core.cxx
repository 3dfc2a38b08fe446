/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include <TissueTessellationCore/Mesh/CellSurfaceCheck.h>

#include <cstdlib>

/** One tetrahedron is a cell. */
int
main()
{
  tissue::WallMesh mesh;
  mesh.points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } };
  mesh.triangles = { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 0, 3, 2 } } };
  mesh.wallOfTriangle.assign(4, 0);
  mesh.walls = { { { { 1, tissue::ExteriorVertex } } } };
  return tissue::CheckCellSurfaces(mesh, 2).cells[1].IsSphere() ? EXIT_SUCCESS : EXIT_FAILURE;
}
