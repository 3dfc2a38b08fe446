/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/UnitedCell.h"
#include "Nerve/ImageTopology.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace tissue_test;

namespace
{
/** A ring of six cells around an axis, in the exterior. */
LabelVolume
RingOfSix()
{
  LabelVolume volume;
  volume.size = { { 30, 30, 14 } };
  for (int i = 0; i < 30 * 30 * 14; ++i)
  {
    const double x = i % 30 - 14.6;
    const double y = i / 30 % 30 - 14.4;
    const double z = i / 900 - 6.5;
    const double radius = std::sqrt(x * x + y * y);
    const auto   sector = static_cast<VertexId>((std::atan2(y, x) / 3.14159265358979 + 1.0) * 3.0);
    volume.vertices.push_back(radius > 5.0 && radius < 12.0 && std::abs(z) < 4.0 ? 1 + std::min(5, sector)
                                                                                 : ExteriorVertex);
  }
  return volume;
}

std::vector<VertexId>
InOrder(std::size_t count)
{
  std::vector<VertexId> cellOf(count);
  std::iota(cellOf.begin(), cellOf.end(), ExteriorVertex);
  return cellOf;
}
} // namespace

TEST(UnitedCell, EachCellIsASphere)
{
  const LabelVolume   volume = VoronoiBall(24);
  const auto          count = *std::max_element(volume.vertices.begin(), volume.vertices.end()) + 1;
  const ImageTopology topology = FindImageTopology(volume, count);
  const auto          cellOf = InOrder(static_cast<std::size_t>(topology.nerve.complex.NumberOfVertices()));
  for (VertexId v = 1; v < count; ++v)
  {
    EXPECT_TRUE(HasOnlySpheres(topology.nerve.complex, cellOf, v)) << v;
  }
}

TEST(UnitedCell, SixCellsOfARingAreATorusFiveOfThemASphere)
{
  const ImageTopology   topology = FindImageTopology(RingOfSix(), 7);
  std::vector<VertexId> cellOf = topology.cellOf;
  const auto            unite = [&](VertexId last) {
    for (VertexId & v : cellOf)
    {
      v = v >= 1 && v <= last ? 1 : v;
    }
  };
  unite(5);
  EXPECT_TRUE(HasOnlySpheres(topology.nerve.complex, cellOf, 1));
  unite(6);
  EXPECT_FALSE(HasOnlySpheres(topology.nerve.complex, cellOf, 1));
}

TEST(UnitedCell, CellsApartAreSeveralSpheres)
{
  const ImageTopology   topology = FindImageTopology(RingOfSix(), 7);
  std::vector<VertexId> cellOf = topology.cellOf;
  std::replace(cellOf.begin(), cellOf.end(), 4, 1);
  EXPECT_TRUE(HasOnlySpheres(topology.nerve.complex, cellOf, 1));
}
