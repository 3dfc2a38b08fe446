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
/** Junctions at the true corners, those at the exterior moved inwards by half a voxel, but for a displacement. */
JunctionSet
DisplacedJunctions(const Point & displacement)
{
  const AdjacencyComplex   complex = MakeComplex();
  const std::vector<Point> corners = TrueCorners();
  JunctionSet              junctions = JunctionsOf(complex, RegularTetrahedron());
  const auto               tetrahedra = complex.GetTetrahedra();
  for (Junction & junction : junctions.junctions)
  {
    const auto at = std::find_if(tetrahedra.begin(), tetrahedra.end(), [&junction](VertexQuadruple t) {
      std::sort(t.begin(), t.end());
      return t == junction.cells;
    });
    junction.position = (1.0 - 0.5 * VoxelLength / Radius) * corners.at(at - tetrahedra.begin()) + displacement;
  }
  return junctions;
}
} // namespace

TEST(CornerFitting, FindsTheCornersBelowTheVoxel)
{
  const LabelVolume        volume = MakeVolume();
  const IndicatorField     field(volume);
  const Point              displacement = 0.2 * VoxelLength * Point{ { 1.0, -1.0, 1.0 } };
  std::vector<std::size_t> unfitted;
  const auto               corners = FitCorners(MakeComplex(), DisplacedJunctions(displacement), field, &unfitted);
  const auto               expected = TrueCorners();
  EXPECT_TRUE(unfitted.empty());
  ASSERT_EQ(corners.size(), expected.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    // The spline rounds those at the exterior off.
    EXPECT_LT(Distance(corners[i], expected[i]), (Norm(expected[i]) > 0.0 ? 0.8 : 0.3) * VoxelLength) << i;
  }
}

TEST(CornerFitting, NamesTheCornersThatTheImageHasNot)
{
  const LabelVolume    volume = MakeVolume();
  const IndicatorField field(volume);
  JunctionSet          junctions = DisplacedJunctions({ { 0.0, 0.0, 0.0 } });
  const auto           last = junctions.junctions.back().cells;
  junctions.junctions.pop_back();
  std::vector<std::size_t> unfitted;
  FitCorners(MakeComplex(), junctions, field, &unfitted);
  ASSERT_EQ(unfitted.size(), 1u);
  VertexQuadruple found = MakeComplex().GetTetrahedra()[unfitted[0]];
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, last);
}
