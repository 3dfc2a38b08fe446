/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CentroidFit_h
#define TissueTessellationCore_CentroidFit_h

#include "TissueTessellationCore/Progress.h"
#include "TissueTessellationCore/TissueSamples.h"

#include <vector>

namespace tissue
{
struct CentroidFitOptions
{
  /** At 0 the seeds stay on the points and all have one metric: Voronoi cells. */
  int numberOfSweeps = 10;
  /** How much of its own shape a cell's metric takes on, 0 (one metric for all) to 0.5; above it shapes feed
   * themselves. */
  double selfAnisotropy = 0.3;
  /** How far each sweep draws a seed back to its point, 0 (points are exact) to 1. */
  double relaxation = 0.0;
};

/** \brief Finds the anisotropic tessellation of a tissue whose cells have their centroids on given points.
 *
 * What is known of cells by their centres alone is that the centres are centroids: of all tessellations, few have their
 * cells' centroids on the points, and such a one shows more of the cells' sizes and shapes than the points' Voronoi
 * cells do. In sweeps each seed moves by a part of the way from its cell's centroid to its point, and its metric
 * follows the cell's shape: M = exp(- selfAnisotropy * deviator of log covariance).
 *
 * \param samples the tissue, by about 500 or more samples a cell.
 * \param points of the cells, at least one.
 * \return a seed for each point, in their order. A point without a sample is left on its own. */
std::vector<MetricSeed>
FitCentroids(const TissueSamples & samples, const std::vector<Point> & points, const CentroidFitOptions & options,
             const ParallelFor & parallelFor = ParallelFor(), const ProgressFunction & progress = ProgressFunction());
} // namespace tissue

#endif
