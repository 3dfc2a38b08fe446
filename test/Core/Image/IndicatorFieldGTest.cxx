/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/IndicatorField.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

namespace
{
using tissue::Point;
using tissue::operator-;

/** A turned image of unequal spacing in which four cells meet at a point, each in a quarter: x and y tell two of the
 * walls, z the third between cells 3 and 4. */
tissue::LabelVolume
MakeVolume()
{
  tissue::LabelVolume volume;
  volume.size = { { 16, 16, 16 } };
  volume.origin = { { 5.0, -3.0, 2.0 } };
  volume.steps = { { { { 0.0, 0.5, 0.0 } }, { { -0.5, 0.0, 0.0 } }, { { 0.0, 0.0, 2.0 } } } };
  for (int z = 0; z < 16; ++z)
  {
    for (int y = 0; y < 16; ++y)
    {
      for (int x = 0; x < 16; ++x)
      {
        volume.vertices.push_back(x < 8 ? 1 : y < 8 ? 2 : z < 8 ? 3 : 4);
      }
    }
  }
  return volume;
}
} // namespace

TEST(IndicatorField, IndicatorsAddUpToOneAlsoAtTheOutside)
{
  const tissue::LabelVolume    volume = MakeVolume();
  const tissue::IndicatorField field(volume);
  for (const Point & index : { Point{ { 7.3, 8.1, 7.7 } }, Point{ { -0.6, 3.2, 15.4 } }, Point{ { 40.0, 0.0, 0.0 } } })
  {
    const Point p = volume.ToPhysical(index);
    double      sum = field.Evaluate(p, { { 0, 1, 2, 3 } }, 4).values[0];
    for (const double value : field.Evaluate(p, { { 1, 2, 3, 4 } }, 4).values)
    {
      sum += value;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

TEST(IndicatorField, GradientsAreThoseOfTheValues)
{
  const tissue::LabelVolume     volume = MakeVolume();
  const tissue::IndicatorField  field(volume);
  const tissue::VertexQuadruple cells{ { 1, 2, 3, 4 } };
  const Point                   p = volume.ToPhysical({ { 7.2, 7.9, 7.4 } });
  const auto                    sample = field.Evaluate(p, cells, 4);
  for (int axis = 0; axis < 3; ++axis)
  {
    constexpr double step = 1e-5;
    Point            further = p;
    further[axis] += step;
    const auto other = field.Evaluate(further, cells, 4);
    for (int c = 0; c < 4; ++c)
    {
      EXPECT_NEAR((other.values[c] - sample.values[c]) / step, sample.gradients[c][axis], 1e-3);
    }
  }
}

TEST(IndicatorField, PointsAreProjectedToWallsAlongTheShortestWay)
{
  const tissue::LabelVolume    volume = MakeVolume();
  const tissue::IndicatorField field(volume);
  Point                        p = volume.ToPhysical({ { 6.4, 3.0, 5.0 } });
  ASSERT_TRUE(field.Project(p, { { 1, 2, -1, -1 } }, 2, 3.0));
  EXPECT_LT(tissue::Distance(p, volume.ToPhysical({ { 7.5, 3.0, 5.0 } })), 1e-3);

  const Point far = volume.ToPhysical({ { 2.0, 3.0, 5.0 } });
  p = far;
  EXPECT_FALSE(field.Project(p, { { 1, 2, -1, -1 } }, 2, 3.0));
  EXPECT_EQ(p, far);
}

TEST(IndicatorField, LinesAndCornersAreWhereAllCellsAreEqual)
{
  const tissue::LabelVolume     volume = MakeVolume();
  const tissue::IndicatorField  field(volume);
  const tissue::VertexQuadruple cells{ { 1, 2, 3, 4 } };
  for (int count = 3; count <= 4; ++count)
  {
    Point p = volume.ToPhysical({ { 8.0, 7.0, count == 3 ? 5.0 : 8.0 } });
    ASSERT_TRUE(field.Project(p, cells, count, 3.0));
    const auto sample = field.Evaluate(p, cells, count);
    for (int c = 1; c < count; ++c)
    {
      EXPECT_NEAR(sample.values[c], sample.values[0], 1e-3);
    }
    const Point expected = volume.ToPhysical({ { 7.5, 7.5, count == 3 ? 5.0 : 7.5 } });
    EXPECT_LT(field.LengthInVoxels(p - expected), 1.0);
  }
}

TEST(IndicatorField, LineDirectionFollowsTheOrderOfTheCells)
{
  const tissue::LabelVolume    volume = MakeVolume();
  const tissue::IndicatorField field(volume);
  const Point                  p = volume.ToPhysical({ { 7.5, 7.5, 4.0 } });
  // Seen against the third axis, cell 1 is at smaller x, cell 2 at larger x and smaller y, cell 3 at larger y.
  const Point direction = field.LineDirection(p, { { 1, 2, 3 } });
  EXPECT_GT(direction[2], 0.0);
  EXPECT_LT(field.LineDirection(p, { { 2, 1, 3 } })[2], 0.0);
  EXPECT_EQ(tissue::Norm(field.LineDirection(p, { { 1, 2, 0 } })), 0.0);
}
