/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CellColors_h
#define CellColors_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <array>
#include <vector>

namespace tissue
{
/** Red, green and blue, 0 to 255. */
using Color = std::array<unsigned char, 3>;

/** \brief A colour for each vertex of the adjacency complex, far from those of its neighbours.
 *
 * One by one, each cell takes the colour of a palette that is farthest, to the eye, from those its neighbours took; of
 * equally good ones, the one that is least in use. Deterministic. */
std::vector<Color>
ChooseCellColors(const WallMesh & mesh, VertexId numberOfVertices);
} // namespace tissue

#endif
