/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_MetricSmoothing_h
#define TissueTessellationCore_MetricSmoothing_h

#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Common/ParallelFor.h"

#include <vector>

namespace tissue
{
/** Of each cell, those next to it. */
using CellNeighbors = std::vector<std::vector<std::size_t>>;

/** Symmetric matrices of cells, definite or not, each replaced by the mean over its cell and the neighbours, so many
 * times. */
std::vector<Metric>
SmoothMetrics(std::vector<Metric> metrics, const CellNeighbors & neighbors, int numberOfPasses,
              const ParallelFor & parallelFor = ParallelFor());
} // namespace tissue

#endif
