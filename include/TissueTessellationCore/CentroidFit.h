/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CentroidFit_h
#define TissueTessellationCore_CentroidFit_h

#include "TissueTessellationCore/CellMoments.h"
#include "TissueTessellationCore/TissueSamples.h"

#include <vector>

namespace tissue
{
/** \brief Finds the anisotropic tessellation of a tissue whose cells have their centroids on given points.
 *
 * What is known of cells by their centres alone is that the centres are centroids: of all tessellations, few have their
 * cells' centroids on the points, and such a one shows more of the cells' sizes and shapes than the points' Voronoi
 * cells do. In sweeps, ten or so, each seed moves by a part of the way from its cell's centroid to its point, and its
 * metric follows the cell's shape: M = exp(- 0.3 * deviator of log covariance), half as much where relaxed. Before the
 * first sweep the cells are the points' Voronoi cells. */
class CentroidFit
{
public:
  /** At least one point. */
  explicit CentroidFit(std::vector<Point> points);

  /** \param samples the tissue, by about 500 or more samples a cell. The seed of a cell without one goes back to its
   * point.
   * \param relaxation how far the seeds are drawn back to their points after their step: 0 where points are exact, up
   * to 1, Voronoi cells but for half of the metrics, where they say little. */
  void
  Sweep(const TissueSamples & samples, double relaxation, const ParallelFor & parallelFor = ParallelFor());

  /** One for each point, in their order. */
  const std::vector<MetricSeed> &
  GetSeeds() const
  {
    return m_Seeds;
  }

private:
  void
  Adapt(std::size_t cell, const CellMoments & moments, double relaxation);

  const std::vector<Point> m_Points;
  std::vector<MetricSeed>  m_Seeds;
  std::vector<Metric>      m_LogMetrics;
};
} // namespace tissue

#endif
