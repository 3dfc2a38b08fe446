/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_AnisotropicTessellation_h
#define TissueTessellationCore_AnisotropicTessellation_h

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Metric.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** A point with its own measure of distance, by which a far point is near along the directions of small eigenvalues. */
struct MetricSeed
{
  Point  position = { { 0.0, 0.0, 0.0 } };
  Metric metric = { { 1.0, 0.0, 0.0, 1.0, 0.0, 1.0 } };
};

/** \brief The tessellation that gives a point x to the seed s of the least (x - s)' M_s (x - s).
 *
 * With one metric for all seeds the cells are Voronoi cells. Otherwise walls are quadrics, and a cell may be in several
 * pieces.
 *
 * A query has two steps. The first finds the candidates for a ball of points, which makes the second cheap for each of
 * the points. The answer does not depend on the ball. */
class AnisotropicTessellation
{
public:
  using SeedId = std::int32_t;

  /** There must be at least one seed, and the metrics must be positive definite, which is not checked. */
  explicit AnisotropicTessellation(std::vector<MetricSeed> seeds);

  const std::vector<MetricSeed> &
  GetSeeds() const
  {
    return m_Seeds;
  }

  /** Replaces `candidates` by all seeds that can be the nearest to any point of the ball, in no special order. */
  void
  FindCandidates(const Point & center, double radius, std::vector<SeedId> & candidates) const;

  /** Finds the nearest of the candidates, of several the one of the least index. There must be a candidate. */
  SeedId
  FindNearest(const Point & point, const std::vector<SeedId> & candidates) const;

private:
  using Bin = std::array<std::int64_t, 3>;

  Bin
  FindBin(const Point & point) const;
  void
  SortSeedsIntoBins();

  std::vector<MetricSeed> m_Seeds;
  /** An upper bound for each seed of the length of a unit vector in its metric. */
  std::vector<double> m_LengthBounds;
  /** A lower bound of the length of a unit vector in the metrics of all seeds. */
  double m_LeastLength = 0.0;

  Point                  m_Origin = { { 0.0, 0.0, 0.0 } };
  double                 m_BinSize = 1.0;
  Bin                    m_NumberOfBins = { { 1, 1, 1 } };
  CompressedRows<SeedId> m_SeedsOfBin;
};
} // namespace tissue

#endif
