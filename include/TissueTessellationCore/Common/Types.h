/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Types_h
#define TissueTessellationCore_Types_h

#include <array>
#include <cstdint>

/** \namespace tissue
 * The core of the module: the adjacency complex of a tissue, its optimization and its dual.
 * Plain C++, without ITK, VTK, files or threads. */
namespace tissue
{
/** A label of the segmented image. It holds the values of every integer pixel type, except for the upper half of the
 * unsigned 64-bit one. */
using Label = std::int64_t;

/** Index of a vertex of the adjacency complex, that is of a cell of the tissue. */
using VertexId = std::int32_t;

/** The exterior of the tissue is a vertex like the others, except that it has no position (paper, section 3.3). As the
 * first one it stands first in every ascending tuple. */
constexpr VertexId ExteriorVertex = 0;

/** Index of a point, and index of a wall, of a wall mesh. */
using PointId = std::int32_t;
using WallId = std::int32_t;

/** A triangle of a mesh, given by its points. */
using Triangle = std::array<PointId, 3>;

/** A position or a vector, in the units and axes of the image's physical space. */
using Point = std::array<double, 3>;

/** An edge, a triangle and a tetrahedron, given by their vertices, which ascend where the tuple serves as a key. */
using VertexPair = std::array<VertexId, 2>;
using VertexTriple = std::array<VertexId, 3>;
using VertexQuadruple = std::array<VertexId, 4>;
} // namespace tissue

#endif
