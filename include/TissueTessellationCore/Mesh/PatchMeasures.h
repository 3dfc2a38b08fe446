/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PatchMeasures_h
#define TissueTessellationCore_PatchMeasures_h

#include "TissueTessellationCore/Mesh/WallPatch.h"

namespace tissue
{
/** The sum of the areas of a patch's triangles. */
double
AreaOf(const WallPatch & patch);

/** The mean TriangleQuality of a patch's triangles; 0 without any. */
double
MeanQuality(const WallPatch & patch);
} // namespace tissue

#endif
