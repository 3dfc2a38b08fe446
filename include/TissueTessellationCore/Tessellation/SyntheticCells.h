/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SyntheticCells_h
#define TissueTessellationCore_SyntheticCells_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Tessellation/TissueSamples.h"

#include <cstdint>
#include <vector>

namespace tissue
{
struct SyntheticCellOptions
{
  /** The number of cells, at least 1. */
  std::int32_t  numberOfCells = 1;
  std::uint64_t seed = 0;
  /** The greatest ratio of the longest to the shortest axis of a founder's metric, at least 1. At 1 all have the same
   * metric and are Voronoi cells; above it each founder has random axes, ratio and size of its own. */
  double anisotropy = 1.0;
  /** The number of cells before the first division, in [1, numberOfCells]. */
  std::int32_t numberOfFounders = 1;
};

/** \brief Grows the cells of a synthetic tissue, as a tessellation.
 *
 * Founders tessellate the tissue, each with its seed about in its centroid (Lloyd's relaxation). Then cells divide, a
 * generation at a time, until there are as many as asked for. Those that divide are the largest, give or take the
 * chance of their growth, and they divide across one of their longer directions. After a division all cells round off:
 * the metric of each becomes that of its covariance, which keeps size, length and flatness but not the corners. The
 * tissue as a whole keeps its size: cells grow between two divisions, and the frame with them.
 *
 * Every cell has at least one sample.
 * \throws std::runtime_error if there are fewer samples than cells, or no arrangement is found.
 * \throws Aborted where `execution` asks to stop. */
AnisotropicTessellation
GrowSyntheticCells(const TissueSamples & samples, const SyntheticCellOptions & options, const Execution & execution);
} // namespace tissue

#endif
