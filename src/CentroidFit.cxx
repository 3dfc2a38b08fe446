/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/CentroidFit.h"

#include "TissueTessellationCore/SymmetricEigen.h"
#include "TissueTessellationCore/Vector.h"

#include <cmath>
#include <utility>

namespace tissue
{
namespace
{
constexpr double SeedStep = 0.7;
constexpr double MetricMixing = 0.3;
/** How much of its own shape a cell's metric takes on; from about 0.5 on shapes feed themselves. */
constexpr double SelfAnisotropy = 0.3;
/** By how much less where the seeds are drawn back all the way: cells of displaced points have their shapes from that.
 */
constexpr double RelaxedShare = 0.5;

/** The logarithm of a cell's metric: against its shape, of whatever size it is. */
Metric
LogMetric(const Metric & covariance, double anisotropy)
{
  Metric       log = MapEigenvalues(covariance, [](double value) { return std::log(value); });
  const double mean = (log[0] + log[3] + log[5]) / 3.0;
  for (const int diagonal : { 0, 3, 5 })
  {
    log[diagonal] -= mean;
  }
  for (double & value : log)
  {
    value *= -anisotropy;
  }
  return log;
}
} // namespace

CentroidFit::CentroidFit(std::vector<Point> points)
  : m_Points(std::move(points))
  , m_Seeds(m_Points.size())
  , m_LogMetrics(m_Points.size(), Metric{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } })
{
  for (std::size_t i = 0; i < m_Points.size(); ++i)
  {
    m_Seeds[i].position = m_Points[i];
  }
}

void
CentroidFit::Sweep(const TissueSamples & samples, double relaxation, const ParallelFor & parallelFor)
{
  const auto cellOfSample = AssignSamples(AnisotropicTessellation(m_Seeds), samples, parallelFor);
  const auto cells = MeasureCells(samples.points, cellOfSample, m_Seeds.size(), samples.boxSize);
  RunFor(parallelFor, m_Seeds.size(), [&](std::size_t i) { this->Adapt(i, cells[i], relaxation); });
}

void
CentroidFit::Adapt(std::size_t cell, const CellMoments & moments, double relaxation)
{
  Point & position = m_Seeds[cell].position;
  if (moments.numberOfPoints == 0)
  {
    position = m_Points[cell];
    return;
  }
  position = position + SeedStep * (m_Points[cell] - moments.mean);
  position = position + relaxation * (m_Points[cell] - position);
  Metric &     log = m_LogMetrics[cell];
  const Metric target = LogMetric(moments.covariance, SelfAnisotropy * (1.0 - RelaxedShare * relaxation));
  for (std::size_t k = 0; k < target.size(); ++k)
  {
    log[k] += MetricMixing * (target[k] - log[k]);
  }
  m_Seeds[cell].metric = MapEigenvalues(log, [](double value) { return std::exp(value); });
}
} // namespace tissue
