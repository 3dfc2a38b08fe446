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
/** Of each cell, those next to it. */
using CellNeighbors = std::vector<std::vector<std::size_t>>;

/** Symmetric matrices of cells, definite or not, each replaced by the mean over its cell and the neighbours, so many
 * times. */
std::vector<Metric>
SmoothMetrics(std::vector<Metric> metrics, const CellNeighbors & neighbors, int numberOfPasses,
              const Execution & execution = Execution());

/** \brief Finds the anisotropic tessellation of a tissue whose cells have their centroids on given points.
 *
 * What is known of cells by their centres alone is that the centres are centroids: of all tessellations, few have their
 * cells' centroids on the points, and such a one shows more of the cells' sizes and shapes than the points' Voronoi
 * cells do. In sweeps, ten or so, each seed moves by a part of the way from its cell's centroid to its point, and its
 * metric follows the shapes of the cell and, far more, of those about it: M = exp(- 0.1 * own - 0.8 * common), a shape
 * being the deviator of the logarithm of a cell's covariance, and the common one a mean over some fifty cells. What one
 * cell shows of its shape is much disturbed where its point and its neighbours' are not quite their centroids; that
 * neighbours are drawn out alike is not. Before the first sweep the cells are the points' Voronoi cells. */
class CentroidFit
{
public:
  /** \param points at least one.
   * \param neighbors of the cell of each point. */
  CentroidFit(std::vector<Point> points, CellNeighbors neighbors);

  /** \param samples the tissue, by about 500 or more samples a cell. The seed of a cell without one goes back to its
   * point.
   * \param relaxation how far the seeds are drawn back to their points after their step: 0 where points are exact, up
   * to 1, Voronoi cells but for the metrics, where they say little. */
  void
  Sweep(const TissueSamples & samples, double relaxation, const Execution & execution = Execution());

  /** One for each point, in their order. */
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
