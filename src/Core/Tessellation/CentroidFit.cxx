/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Tessellation/CentroidFit.h"

#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>
#include <utility>

namespace tissue
{
std::vector<Metric>
SmoothMetrics(std::vector<Metric> metrics, const CellNeighbors & neighbors, int numberOfPasses,
              const Execution & execution)
{
  std::vector<Metric> means(metrics.size());
  for (int pass = 0; pass < numberOfPasses; ++pass)
  {
    execution.For(metrics.size(), [&](std::size_t cell) {
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

namespace
{
/** The shape of a ball: a deviator of zero. */
constexpr Metric NoShape = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
/** The share of the way from its cell's centroid to its point that a seed moves in a sweep. Less than the whole damps
 * the fit, as neighbours move at the same time. */
constexpr double SeedStep = 0.7;
/** The share of the way to its new value that the logarithm of a metric goes in a sweep. It damps the fit, too. */
constexpr double MetricMixing = 0.3;
/** How much of its own shape a cell's metric takes on, and how much of the shapes about it. From about 0.5 on a cell's
 * own shape would feed itself; a shape that many cells have in common does not. */
constexpr double SelfAnisotropy = 0.1;
constexpr double CommonAnisotropy = 0.8;
/** The passes of averaging over neighbours that make the common shape, which so is that of some fifty cells. */
constexpr int SmoothingPasses = 3;

/** Gives the shape of a cell whatever its size: the deviator of the logarithm of its covariance. */
Metric
ShapeOf(const Metric & covariance)
{
  Metric       shape = MapEigenvalues(covariance, [](double value) { return std::log(value); });
  const double mean = (shape[0] + shape[3] + shape[5]) / 3.0;
  for (const int diagonal : { 0, 3, 5 })
  {
    shape[diagonal] -= mean;
  }
  return shape;
}
} // namespace

CentroidFit::CentroidFit(std::vector<Point> points, CellNeighbors neighbors)
  : m_Points(std::move(points))
  , m_Neighbors(std::move(neighbors))
  , m_Seeds(m_Points.size())
  , m_LogMetrics(m_Points.size(), NoShape)
{
  for (std::size_t i = 0; i < m_Points.size(); ++i)
  {
    m_Seeds[i].position = m_Points[i];
  }
}

void
CentroidFit::Sweep(const TissueSamples & samples, double relaxation, const Execution & execution)
{
  const auto          cellOfSample = AssignSamples(AnisotropicTessellation(m_Seeds), samples, execution);
  const auto          cells = MeasureCells(samples.points, cellOfSample, m_Seeds.size(), samples.boxSize);
  std::vector<Metric> shapes(m_Seeds.size(), NoShape);
  execution.For(m_Seeds.size(), [&](std::size_t i) {
    this->Move(i, cells[i], relaxation);
    if (cells[i].numberOfPoints > 0)
    {
      shapes[i] = ShapeOf(cells[i].covariance);
    }
  });
  const std::vector<Metric> common = SmoothMetrics(shapes, m_Neighbors, SmoothingPasses, execution);
  execution.For(m_Seeds.size(), [&](std::size_t i) {
    Metric & log = m_LogMetrics[i];
    for (std::size_t k = 0; k < log.size(); ++k)
    {
      log[k] -= MetricMixing * (SelfAnisotropy * shapes[i][k] + CommonAnisotropy * common[i][k] + log[k]);
    }
    m_Seeds[i].metric = MapEigenvalues(log, [](double value) { return std::exp(value); });
  });
}

void
CentroidFit::Move(std::size_t cell, const CellMoments & moments, double relaxation)
{
  Point & position = m_Seeds[cell].position;
  if (moments.numberOfPoints == 0)
  {
    position = m_Points[cell];
    return;
  }
  position = position + SeedStep * (m_Points[cell] - moments.mean);
  position = position + relaxation * (m_Points[cell] - position);
}
} // namespace tissue
