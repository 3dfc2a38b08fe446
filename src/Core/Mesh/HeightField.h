/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_HeightField_h
#define TissueTessellationCore_HeightField_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** The angle between two triangles at an edge, in degrees, that those of a height field exceed. */
constexpr double LeastFoldOfHeightField = 20.0;

/** \brief Tells of triangles of one wall, [first, end), whether they are proven to be a height field: seen from one
 * direction none hides another.
 *
 * So they cross nowhere, and none is folded onto another by LeastFoldOfHeightField or less. The proof: all face the
 * direction of the sum of their normals, and their outline, seen from there, winds once about the mean of its points.
 * Each place is then covered as often as the outline winds about it, which is once within it and never outside. Most
 * walls of a tissue are height fields; of the others some are not found, those whose outline is no star. */
bool
IsHeightField(const WallMesh & mesh, std::size_t first, std::size_t end);

/** Marks the runs of triangles that are wanted and are height fields. Run r is firstOfRuns[r] ... firstOfRuns[r + 1]
 * - 1. */
std::vector<unsigned char>
MarkHeightFields(const WallMesh & mesh, const std::vector<std::size_t> & firstOfRuns,
                 const std::vector<unsigned char> & isWanted, const Execution & execution);
} // namespace tissue

#endif
