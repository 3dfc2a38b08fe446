/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/BlobNoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace tissue;

namespace
{
/** The discrete Gaussian of this variance, in voxels, from -60 to 60: exp(-v) I_n(v). */
std::vector<double>
Gaussian(double variance)
{
  std::vector<double> kernel;
  for (int n = -60; n <= 60; ++n)
  {
    double sum = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * i / 400.0;
      sum += std::exp(-variance * (1.0 - std::cos(angle))) * std::cos(n * angle) / 400.0;
    }
    kernel.push_back(sum);
  }
  return kernel;
}

/** The root of the sum of the squared weights of the difference of two Gaussians, which is the response of noise. */
double
Summed(double scale, double step, const std::array<double, 3> & spacing)
{
  std::array<std::vector<double>, 3> fine;
  std::array<std::vector<double>, 3> coarse;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double variance = scale * scale / (spacing[axis] * spacing[axis]);
    fine[axis] = Gaussian(variance / step);
    coarse[axis] = Gaussian(variance * step);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < 121; ++i)
  {
    for (std::size_t j = 0; j < 121; ++j)
    {
      for (std::size_t k = 0; k < 121; ++k)
      {
        const double weight = fine[0][i] * fine[1][j] * fine[2][k] - coarse[0][i] * coarse[1][j] * coarse[2][k];
        sum += weight * weight;
      }
    }
  }
  return std::sqrt(sum) / std::log(step);
}
} // namespace

TEST(BlobNoise, ResponseIsThatOfTheSummedWeights)
{
  const double step = std::pow(2.0, 0.25);
  for (const double scale : { 0.5, 1.1, 2.7, 6.0 })
  {
    const std::array<double, 3> spacing{ { 1.0, 1.0, 2.5 } };
    EXPECT_NEAR(NoiseResponse(scale, step, spacing) / Summed(scale, step, spacing), 1.0, 1e-3) << scale;
  }
  // In voxels far smaller than the scale it falls by scale^-1.5.
  const std::array<double, 3> cube{ { 0.3, 0.3, 0.3 } };
  EXPECT_NEAR(NoiseResponse(8.0, step, cube) / NoiseResponse(4.0, step, cube), std::pow(2.0, -1.5), 1e-3);
}

TEST(BlobNoise, SmoothingLeavesTheRootOfTheSquaredWeights)
{
  EXPECT_NEAR(SmoothedNoise(0.0, { { 1.0, 1.0, 1.0 } }), 1.0, 1e-12);
  double product = 1.0;
  for (const double variance : { 4.0, 4.0, 1.0 }) // of a scale of 2 in voxels of 1, 1 and 2
  {
    double sum = 0.0;
    for (const double weight : Gaussian(variance))
    {
      sum += weight * weight;
    }
    product *= sum;
  }
  EXPECT_NEAR(SmoothedNoise(2.0, { { 1.0, 1.0, 2.0 } }), std::sqrt(product), 1e-4);
}

TEST(BlobNoise, IsGreaterOnTheBorderWhereOneVoxelCountsAsMany)
{
  const auto share = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  for (const double scale : { 1.0, 2.0, 4.0 })
  {
    EXPECT_NEAR(BorderNoise(6.0 * scale, scale), 1.0, 1e-6);
    for (const double distance : { 0.0, 1.0, 3.0 })
    {
      double border = std::pow(share((0.5 - distance) / scale), 2);
      double inside = 0.0;
      for (int i = -60; i <= 60; ++i)
      {
        const auto weight = [&](double x) { return share((x + 0.5) / scale) - share((x - 0.5) / scale); };
        border += i > 0 ? std::pow(weight(i - distance), 2) : 0.0;
        inside += std::pow(weight(i), 2);
      }
      EXPECT_NEAR(BorderNoise(distance, scale) / std::sqrt(border / inside), 1.0, 0.02) << scale << ' ' << distance;
    }
  }
}

TEST(BlobNoise, EvidenceGrowsSlowlyWithTheImage)
{
  EXPECT_NEAR(LeastBlobEvidence(1.0), 0.7, 1e-12);
  EXPECT_NEAR(LeastBlobEvidence(1e6), 5.957, 1e-3);
  EXPECT_NEAR(LeastBlobEvidence(1e9), 7.138, 1e-3);
}
