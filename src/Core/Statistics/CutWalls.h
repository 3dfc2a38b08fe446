/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CutWalls_h
#define TissueTessellationCore_CutWalls_h

#include "Statistics/OuterSurface.h"
#include "Statistics/OuterTriangles.h"

#include <vector>

namespace tissue
{
/** Finds the planes within an image that cut a tissue, by the rules of MeasureTissue(). \param voxelLength the edge of
 * a voxel; 0 where there is no image. */
std::vector<CutPlane>
FindCutPlanes(const OuterSurface & surface, double voxelLength);

/** Marks the walls of the surface at which cells are missing, by the rules of MeasureTissue(). None must be marked
 * before. */
void
MarkCutWalls(OuterSurface & surface);
} // namespace tissue

#endif
