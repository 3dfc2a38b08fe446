/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/CentroidFit.h"

#include "TissueTessellationCore/CellMoments.h"
#include "TissueTessellationCore/SymmetricEigen.h"
#include "TissueTessellationCore/Vector.h"

#include <cmath>

namespace tissue
{
namespace
{
constexpr double SeedStep = 0.7;
constexpr double MetricMixing = 0.3;

/** The logarithm of a cell's metric: against its shape, of whatever size it is. */
Metric
LogMetric(const Metric & covariance, double selfAnisotropy)
{
  Metric       log = MapEigenvalues(covariance, [](double value) { return std::log(value); });
  const double mean = (log[0] + log[3] + log[5]) / 3.0;
  for (const int diagonal : { 0, 3, 5 })
  {
    log[diagonal] -= mean;
  }
  for (double & value : log)
  {
    value *= -selfAnisotropy;
  }
  return log;
}
} // namespace

std::vector<MetricSeed>
FitCentroids(const TissueSamples & samples, const std::vector<Point> & points, const CentroidFitOptions & options,
             const ParallelFor & parallelFor, const ProgressFunction & progress)
{
  std::vector<MetricSeed> seeds(points.size());
  std::vector<Metric>     logMetrics(points.size(), Metric{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } });
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    seeds[i].position = points[i];
  }
  for (int sweep = 0; sweep < options.numberOfSweeps; ++sweep)
  {
    const auto cellOfSample = AssignSamples(AnisotropicTessellation(seeds), samples, parallelFor);
    const auto cells = MeasureCells(samples.points, cellOfSample, points.size(), samples.boxSize);
    RunFor(parallelFor, seeds.size(), [&](std::size_t i) {
      Point & position = seeds[i].position;
      if (cells[i].numberOfPoints == 0)
      {
        position = points[i];
        return;
      }
      position = position + SeedStep * (points[i] - cells[i].mean);
      position = position + options.relaxation * (points[i] - position);
      const Metric target = LogMetric(cells[i].covariance, options.selfAnisotropy);
      for (std::size_t k = 0; k < target.size(); ++k)
      {
        logMetrics[i][k] += MetricMixing * (target[k] - logMetrics[i][k]);
      }
      seeds[i].metric = MapEigenvalues(logMetrics[i], [](double value) { return std::exp(value); });
    });
    Report(progress, static_cast<double>(sweep + 1) / options.numberOfSweeps);
  }
  return seeds;
}
} // namespace tissue
