/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Tessellation/AnisotropicTessellation.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tissue
{
namespace
{
double
SquaredDistance(const MetricSeed & seed, const Point & point)
{
  return QuadraticForm(seed.metric, point - seed.position);
}

double
FrobeniusNorm(const Metric & m)
{
  return std::sqrt(m[0] * m[0] + m[3] * m[3] + m[5] * m[5] + 2.0 * (m[1] * m[1] + m[2] * m[2] + m[4] * m[4]));
}

/** Visits the bins of the grid at a Chebyshev distance of exactly `shell` from the bin `home`, itself in the grid or
 * not.
 */
template <typename TVisitor>
void
VisitShell(const std::array<std::int64_t, 3> & home, std::int64_t shell,
           const std::array<std::int64_t, 3> & numberOfBins, const TVisitor & visitBin)
{
  const auto first = [&](std::size_t i) { return std::max<std::int64_t>(home[i] - shell, 0); };
  const auto last = [&](std::size_t i) { return std::min(home[i] + shell, numberOfBins[i] - 1); };
  for (std::int64_t z = first(2); z <= last(2); ++z)
  {
    for (std::int64_t y = first(1); y <= last(1); ++y)
    {
      const bool isFace = std::abs(z - home[2]) == shell || std::abs(y - home[1]) == shell;
      for (std::int64_t x = first(0); x <= last(0); ++x)
      {
        if (isFace || std::abs(x - home[0]) == shell)
        {
          visitBin(x, y, z);
        }
      }
    }
  }
}
} // namespace

AnisotropicTessellation::AnisotropicTessellation(std::vector<MetricSeed> seeds)
  : m_Seeds(std::move(seeds))
{
  m_LengthBounds.reserve(m_Seeds.size());
  double greatestInverse = 0.0;
  for (const MetricSeed & seed : m_Seeds)
  {
    m_LengthBounds.push_back(std::sqrt(FrobeniusNorm(seed.metric)));
    greatestInverse = std::max(greatestInverse, FrobeniusNorm(Inverse(seed.metric)));
  }
  m_LeastLength = 1.0 / std::sqrt(greatestInverse);
  this->SortSeedsIntoBins();
}

AnisotropicTessellation::Bin
AnisotropicTessellation::FindBin(const Point & point) const
{
  Bin bin;
  for (std::size_t i = 0; i < 3; ++i)
  {
    bin[i] = static_cast<std::int64_t>(std::floor((point[i] - m_Origin[i]) / m_BinSize));
  }
  return bin;
}

void
AnisotropicTessellation::SortSeedsIntoBins()
{
  m_Origin = m_Seeds.front().position;
  Point upper = m_Origin;
  for (const MetricSeed & seed : m_Seeds)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      m_Origin[i] = std::min(m_Origin[i], seed.position[i]);
      upper[i] = std::max(upper[i], seed.position[i]);
    }
  }
  const double extent = std::max({ upper[0] - m_Origin[0], upper[1] - m_Origin[1], upper[2] - m_Origin[2] });
  m_BinSize = extent > 0.0 ? extent / std::cbrt(static_cast<double>(m_Seeds.size())) : 1.0;
  m_NumberOfBins = this->FindBin(upper);
  for (std::int64_t & number : m_NumberOfBins)
  {
    ++number;
  }
  const auto binIndex = [this](const MetricSeed & seed) {
    const Bin bin = this->FindBin(seed.position);
    return static_cast<std::size_t>((bin[2] * m_NumberOfBins[1] + bin[1]) * m_NumberOfBins[0] + bin[0]);
  };
  const std::int64_t numberOfBins = m_NumberOfBins[0] * m_NumberOfBins[1] * m_NumberOfBins[2];
  m_SeedsOfBin.Assign(static_cast<std::size_t>(numberOfBins), [&](const auto & add) {
    for (std::size_t i = 0; i < m_Seeds.size(); ++i)
    {
      add(binIndex(m_Seeds[i]), static_cast<SeedId>(i));
    }
  });
}

void
AnisotropicTessellation::FindCandidates(const Point & center, double radius, std::vector<SeedId> & candidates) const
{
  candidates.clear();
  // No point of the ball is farther than this from its nearest seed.
  double     bound = std::numeric_limits<double>::infinity();
  const auto visitBin = [&](std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto bin = static_cast<std::size_t>((z * m_NumberOfBins[1] + y) * m_NumberOfBins[0] + x);
    for (const SeedId seed : m_SeedsOfBin[bin])
    {
      bound = std::min(bound, std::sqrt(SquaredDistance(m_Seeds[seed], center)) + m_LengthBounds[seed] * radius);
      candidates.push_back(seed);
    }
  };
  // Shells of bins around the centre's, until one is too far off for every metric.
  const Bin    home = this->FindBin(center);
  std::int64_t lastShell = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    lastShell = std::max({ lastShell, std::abs(home[i]), std::abs(m_NumberOfBins[i] - 1 - home[i]) });
  }
  for (std::int64_t shell = 0; shell <= lastShell; ++shell)
  {
    if (m_LeastLength * (m_BinSize * static_cast<double>(shell - 1) - radius) > bound)
    {
      break;
    }
    VisitShell(home, shell, m_NumberOfBins, visitBin);
  }
  const auto isTooFar = [&](SeedId seed) {
    // The margin covers rounding.
    return std::sqrt(SquaredDistance(m_Seeds[seed], center)) - m_LengthBounds[seed] * radius > bound * (1.0 + 1e-9);
  };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), isTooFar), candidates.end());
}

AnisotropicTessellation::SeedId
AnisotropicTessellation::FindNearest(const Point & point, const std::vector<SeedId> & candidates) const
{
  SeedId nearest = candidates.front();
  double least = std::numeric_limits<double>::infinity();
  for (const SeedId seed : candidates)
  {
    const double distance = SquaredDistance(m_Seeds[seed], point);
    if (distance < least || (distance == least && seed < nearest))
    {
      least = distance;
      nearest = seed;
    }
  }
  return nearest;
}
} // namespace tissue
