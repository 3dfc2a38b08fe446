/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Tessellation/CentroidFit.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
const Metric Zero{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
const Metric Six{ { 6.0, -6.0, 0.0, 12.0, 6.0, -18.0 } };

/** Three cells in a row and one alone. */
const CellNeighbors Row{ { 1 }, { 0, 2 }, { 1 }, {} };
} // namespace

TEST(MetricSmoothing, IsTheMeanOverACellAndItsNeighbors)
{
  const auto once = SmoothMetrics({ Six, Zero, Zero, Six }, Row, 1);
  for (std::size_t k = 0; k < Six.size(); ++k)
  {
    EXPECT_DOUBLE_EQ(once[0][k], Six[k] / 2.0);
    EXPECT_DOUBLE_EQ(once[1][k], Six[k] / 3.0);
    EXPECT_DOUBLE_EQ(once[2][k], 0.0);
    EXPECT_DOUBLE_EQ(once[3][k], Six[k]);
  }
  const auto twice = SmoothMetrics({ Six, Zero, Zero, Six }, Row, 2);
  EXPECT_DOUBLE_EQ(twice[2][0], once[1][0] / 2.0);
  EXPECT_DOUBLE_EQ(twice[1][0], (once[0][0] + once[1][0]) / 3.0);
}

TEST(MetricSmoothing, LeavesWhatIsTheSameEverywhere)
{
  for (const Metric & metric : SmoothMetrics({ Six, Six, Six, Six }, Row, 5))
  {
    for (std::size_t k = 0; k < Six.size(); ++k)
    {
      EXPECT_NEAR(metric[k], Six[k], 1e-12);
    }
  }
}
