/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CornerFitting.h"
#include "FourCellBall.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
const std::vector<VertexId> Whole{ 0, 1, 2, 3, 4 };

/** The dual with its corners half a voxel inside, where they are at the exterior, but for a displacement. */
ImageDual
DisplacedDual(const Point & displacement)
{
  std::vector<Point> corners = TrueCorners();
  for (Point & corner : corners)
  {
    corner = (1.0 - 0.5 * VoxelLength / Radius) * corner + displacement;
  }
  return { Dualize(MakeComplex(), corners), std::vector<bool>(corners.size(), true) };
}
} // namespace

TEST(CornerFitting, FindsTheCornersBelowTheVoxel)
{
  const LabelVolume    volume = MakeVolume();
  const IndicatorField field(volume);
  ImageDual            dual = DisplacedDual(0.2 * VoxelLength * Point{ { 1.0, -1.0, 1.0 } });
  const auto           expected = TrueCorners();
  EXPECT_TRUE(FitCorners(dual, Whole, field).empty());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    // The spline rounds those at the exterior off.
    EXPECT_LT(Distance(dual.mesh.corners[i], expected[i]), (Norm(expected[i]) > 0.0 ? 0.8 : 0.3) * VoxelLength) << i;
  }
}

TEST(CornerFitting, NamesTheCornersThatTheImageHasNot)
{
  const LabelVolume    volume = MakeVolume();
  const IndicatorField field(volume);
  ImageDual            dual = DisplacedDual({ { 0.0, 0.0, 0.0 } });
  dual.isInImage[3] = false;
  EXPECT_EQ(FitCorners(dual, Whole, field), (std::vector<std::size_t>{ 3 }));
}

TEST(CornerFitting, CornersOfDividedCellsComeToTheLineOfTheirCells)
{
  // Cells 3 and 4 are one here: what was a corner of cells 1 to 4 is a point of the line of 1, 2 and them.
  LabelVolume volume = MakeVolume();
  volume.vertices.Replace(4, 3);
  const IndicatorField     field(volume);
  ImageDual                dual = DisplacedDual({ { 0.0, 0.0, 0.0 } });
  std::size_t              inner = 0;
  const std::vector<Point> corners = TrueCorners();
  while (Norm(corners[inner]) > 0.5)
  {
    ++inner;
  }
  dual.mesh.corners[inner] = { { 0.5 * VoxelLength, -0.5 * VoxelLength, 0.5 * VoxelLength } };
  EXPECT_TRUE(FitCorners(dual, { 0, 1, 2, 3, 3 }, field).empty());
  const auto sample = field.Evaluate(dual.mesh.corners[inner], { { 1, 2, 3, -1 } }, 3);
  EXPECT_NEAR(sample.values[0], sample.values[1], 0.05);
  EXPECT_NEAR(sample.values[0], sample.values[2], 0.05);
}
