/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CentroidFit_h
#define TissueTessellationCore_CentroidFit_h

#include "Tessellation/CellMoments.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Tessellation/TissueSamples.h"

#include <vector>

namespace tissue
{
/** The cells next to each cell. */
using CellNeighbors = std::vector<std::vector<std::size_t>>;

/** Replaces the symmetric matrix of each cell, which need not be definite, by the mean over the cell and its
 * neighbours, as many times as there are passes. */
std::vector<Metric>
SmoothMetrics(std::vector<Metric> metrics, const CellNeighbors & neighbors, int numberOfPasses,
              const Execution & execution = Execution());

/** \brief Finds the anisotropic tessellation of a tissue whose cells have their centroids on given points.
 *
 * What the centres alone tell of cells is that they are centroids. Few of all tessellations have their cells' centroids
 * on the points, and such a one shows more of the cells' sizes and shapes than the points' Voronoi cells do.
 *
 * Before the first sweep the cells are the points' Voronoi cells. In each of some ten sweeps a seed moves a part of the
 * way from its cell's centroid to its point, and its metric follows the shape of the cell and, far more, the shapes
 * about it: M = exp(- 0.1 * own - 0.8 * common). A shape is the deviator of the logarithm of a cell's covariance, the
 * common one a mean over some fifty cells. What one cell shows of its shape is much disturbed where its point and its
 * neighbours' are not quite their centroids; that neighbours are drawn out alike is not. */
class CentroidFit
{
public:
  /** \param points the centres of the cells, at least one.
   * \param neighbors the cells next to the cell of each point. */
  CentroidFit(std::vector<Point> points, CellNeighbors neighbors);

  /** Moves all seeds and adapts their metrics once.
   * \param samples the tissue, by about 500 or more samples a cell. The seed of a cell without one goes back to its
   * point.
   * \param relaxation how far the seeds are drawn back to their points after their step, 0 .. 1. It should be 0 where
   * points are exact; at 1 the cells are Voronoi cells but for the metrics. */
  void
  Sweep(const TissueSamples & samples, double relaxation, const Execution & execution = Execution());

  /** The seeds, one for each point and in the order of the points. */
  const std::vector<MetricSeed> &
  GetSeeds() const
  {
    return m_Seeds;
  }

private:
  void
  Move(std::size_t cell, const CellMoments & moments, double relaxation);

  const std::vector<Point> m_Points;
  const CellNeighbors      m_Neighbors;
  std::vector<MetricSeed>  m_Seeds;
  std::vector<Metric>      m_LogMetrics;
};
} // namespace tissue

#endif
