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
/** A label of the segmented image. Holds every integer pixel type but the upper half of the unsigned 64-bit one. */
using Label = std::int64_t;

/** Index of a vertex of the adjacency complex, that is of a cell of the tissue. */
using VertexId = std::int32_t;

/** The exterior of the tissue is a vertex like the others, but for its position, which it has not (paper, section 3.3).
 */
constexpr VertexId ExteriorVertex = 0;

/** Indices of the points and walls of a wall mesh. */
using PointId = std::int32_t;
using WallId = std::int32_t;

/** A triangle of a mesh, by its points. */
using Triangle = std::array<PointId, 3>;

/** Position or vector, in the units and axes of the image's physical space. */
using Point = std::array<double, 3>;

/** An edge, triangle or tetrahedron by its vertices, in ascending order where it serves as a key. */
using VertexPair = std::array<VertexId, 2>;
using VertexTriple = std::array<VertexId, 3>;
using VertexQuadruple = std::array<VertexId, 4>;
} // namespace tissue

#endif
