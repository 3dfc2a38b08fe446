/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointTissueInput_h
#define PointTissueInput_h

#include "NucleiTessellation/NucleiTessellationOptions.h"
#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Reconstruction/TissueInput.h"

namespace tissue
{
/** Reads the centres of the cells and makes of them what the options say: the junctions of a label image made of them,
 * or, for the paper's method, cells without any.
 * \throws FileError: files that cannot be read, fewer than four points, points outside of the box, points in one plane
 * that are to be of a solid tissue. */
TissueInput
ReadPointTissue(const NucleiTessellationOptions & options, ProgressBar & progress);
} // namespace tissue

#endif
