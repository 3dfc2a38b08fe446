/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionOutput_h
#define ReconstructionOutput_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Reconstruction/OutputPaths.h"
#include "Shared/Reconstruction/ReconstructionReport.h"

namespace tissue
{
/** Writes all that is asked for, or nothing. \throws std::runtime_error: what, path, why. */
void
WriteOutputs(const OutputPaths & paths, const ReconstructionReport & report, ProgressBar & progress);
} // namespace tissue

#endif
