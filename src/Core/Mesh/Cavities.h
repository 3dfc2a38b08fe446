/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Cavities_h
#define TissueTessellationCore_Cavities_h

#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** A hole of exterior in a single cell. */
struct Cavity
{
  VertexId cell;
  /** Those around it, ascending. */
  std::vector<WallId> walls;
  Box                 box;
  double              volume;
};

/** Finds the holes of exterior in single cells: walls of a cell and the exterior that hang together at points, and no
 * other cell is at, that are closed, with the exterior within them. In the order of their least points. */
std::vector<Cavity>
FindCavities(const WallMesh & mesh);
} // namespace tissue

#endif
