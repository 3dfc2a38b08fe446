/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/NearestPoints.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace tissue;

TEST(NearestPoints, AreThoseOfAllComparisons)
{
  // In space, in a plane, on a line, and on a lattice with its equal distances.
  for (const int kind : { 0, 1, 2, 3 })
  {
    Random             random(7);
    std::vector<Point> points;
    for (int i = 0; i < 400; ++i)
    {
      const Point anywhere{ { random.Uniform(), random.Uniform(), random.Uniform() } };
      const Point onLattice{ { i % 7 * 1.0, i / 7 % 7 * 1.0, i / 49 * 1.0 } };
      points.push_back(
        kind == 3 ? onLattice : Point{ { anywhere[0], kind < 2 ? anywhere[1] : 0.0, kind < 1 ? anywhere[2] : 0.0 } });
    }
    const auto nearest = FindNearestPoints(points, 9);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      std::vector<std::pair<double, std::size_t>> all;
      for (std::size_t j = 0; j < points.size(); ++j)
      {
        const Point offset = points[j] - points[i];
        if (j != i)
        {
          all.emplace_back(Dot(offset, offset), j);
        }
      }
      std::sort(all.begin(), all.end());
      ASSERT_EQ(nearest[i].size(), 9u);
      for (std::size_t k = 0; k < 9; ++k)
      {
        EXPECT_EQ(nearest[i][k], all[k].second) << kind << ' ' << i << ' ' << k;
      }
    }
  }
}

TEST(NearestPoints, AreAllOthersWhereThereAreFew)
{
  const auto nearest = FindNearestPoints({ { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 1, 0, 0 } } }, 8);
  EXPECT_EQ(nearest[0], (std::vector<std::size_t>{ 2, 1 }));
  EXPECT_TRUE(FindNearestPoints({ { { 0, 0, 0 } } }, 8)[0].empty());
  EXPECT_TRUE(FindNearestPoints({}, 8).empty());
}
