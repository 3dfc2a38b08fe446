/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/BlobNoise.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

/** The middle value of the discrete Gaussian of this variance, exp(-v) I0(v), in voxels (T. Lindeberg 1990,
 * doi:10.1109/34.49051). It is the product of any two discrete Gaussians whose variances add to this. */
double
MiddleOfGaussian(double variance)
{
  constexpr double large = 20.0;
  if (variance > large)
  {
    return (1.0 + 0.125 / variance) / std::sqrt(2.0 * Pi * variance);
  }
  // The mean of exp(-v (1 - cos t)) over a circle, which so many points give to ten digits.
  constexpr int points = 32;
  double        sum = 0.0;
  for (int i = 0; i < points; ++i)
  {
    sum += std::exp(-variance * (1.0 - std::cos(2.0 * Pi * i / points)));
  }
  return sum / points;
}

/** The product of two Gaussians whose variances add to this, which is what two images that are smoothed by them have in
 * common of noise of deviation 1. */
double
Covariance(double variance, const std::array<double, 3> & spacing)
{
  double product = 1.0;
  for (const double size : spacing)
  {
    product *= MiddleOfGaussian(variance / (size * size));
  }
  return product;
}

/** The share of a normal distribution below this many deviations. */
double
NormalShare(double deviations)
{
  return 0.5 * std::erfc(-deviations / std::sqrt(2.0));
}
} // namespace

double
NoiseResponse(double scale, double step, const std::array<double, 3> & spacing)
{
  // The variance of the difference of two smoothed images is the sum of both variances less twice their covariance.
  const double square = scale * scale;
  const double difference = Covariance(2.0 * square / step, spacing) + Covariance(2.0 * square * step, spacing) -
                            2.0 * Covariance(square * (step + 1.0 / step), spacing);
  return std::sqrt(std::max(difference, 0.0)) / std::log(step);
}

double
SmoothedNoise(double scale, const std::array<double, 3> & spacing)
{
  return std::sqrt(Covariance(2.0 * scale * scale, spacing));
}

double
BorderNoise(double distance, double scale)
{
  // Variances: of the voxels within the border, and of the outermost, which has all the weight beyond it.
  const double toFirst = (distance - 0.5) / scale;
  const double outermost = NormalShare(-toFirst);
  return std::sqrt(NormalShare(std::sqrt(2.0) * toFirst) + 2.0 * std::sqrt(Pi) * scale * outermost * outermost);
}

double
LeastBlobEvidence(double places)
{
  return std::sqrt(2.0 * std::log(std::max(places, 1.0))) + 0.7;
}
} // namespace tissue
