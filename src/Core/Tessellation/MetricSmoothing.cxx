/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Tessellation/MetricSmoothing.h"

namespace tissue
{
std::vector<Metric>
SmoothMetrics(std::vector<Metric> metrics, const CellNeighbors & neighbors, int numberOfPasses,
              const ParallelFor & parallelFor)
{
  std::vector<Metric> means(metrics.size());
  for (int pass = 0; pass < numberOfPasses; ++pass)
  {
    RunFor(parallelFor, metrics.size(), [&](std::size_t cell) {
      Metric mean = metrics[cell];
      for (std::size_t k = 0; k < mean.size(); ++k)
      {
        for (const std::size_t neighbor : neighbors[cell])
        {
          mean[k] += metrics[neighbor][k];
        }
        mean[k] /= static_cast<double>(neighbors[cell].size() + 1);
      }
      means[cell] = mean;
    });
    metrics.swap(means);
  }
  return metrics;
}
} // namespace tissue
