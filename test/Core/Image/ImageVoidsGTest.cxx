/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/ImageVoids.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** A block of 7 x 6 x 5 voxels of cell 1, in exterior one voxel wide. */
class ImageVoids : public testing::Test
{
protected:
  ImageVoids()
  {
    m_Volume.size = { { 9, 8, 7 } };
    m_Volume.vertices = VoxelVertices(9 * 8 * 7, ExteriorVertex);
    for (int z = 1; z < 6; ++z)
    {
      for (int y = 1; y < 7; ++y)
      {
        for (int x = 1; x < 8; ++x)
        {
          this->Put(x, y, z, 1);
        }
      }
    }
  }

  void
  Put(int x, int y, int z, VertexId vertex)
  {
    m_Volume.vertices.Put(static_cast<std::size_t>((z * 8 + y) * 9 + x), vertex);
  }

  LabelVolume m_Volume;
};
} // namespace

TEST_F(ImageVoids, AreCountedByVoxels)
{
  EXPECT_TRUE(FindVoidsInCells(m_Volume).empty());
  // A corner of three voxels, whose first one is not in the row of the others; and one voxel that touches it at an
  // edge.
  for (const auto & [x, y, z] : std::vector<std::array<int, 3>>{ { 3, 3, 2 }, { 3, 3, 3 }, { 2, 3, 3 }, { 4, 4, 3 } })
  {
    this->Put(x, y, z, ExteriorVertex);
  }
  const auto voids = FindVoidsInCells(m_Volume);
  ASSERT_EQ(voids.size(), 2u);
  EXPECT_EQ(voids[0].cell, 1);
  EXPECT_EQ(voids[0].voxels, 3);
  EXPECT_EQ(voids[0].first, (std::array<std::int32_t, 3>{ { 3, 3, 2 } }));
  EXPECT_EQ(voids[1].voxels, 1);
}

TEST_F(ImageVoids, AreClosedOnAllSides)
{
  for (int x = 4; x < 8; ++x)
  {
    this->Put(x, 3, 3, ExteriorVertex);
  }
  EXPECT_TRUE(FindVoidsInCells(m_Volume).empty());
  this->Put(7, 3, 3, 1);
  EXPECT_EQ(FindVoidsInCells(m_Volume).size(), 1u);
}

TEST_F(ImageVoids, AreWithinOneCellAlone)
{
  this->Put(3, 3, 3, ExteriorVertex);
  this->Put(3, 3, 4, 2);
  EXPECT_TRUE(FindVoidsInCells(m_Volume).empty());
}

TEST_F(ImageVoids, AreNotOnTheBorderOfTheImage)
{
  m_Volume.vertices = VoxelVertices(m_Volume.vertices.size(), 1);
  this->Put(0, 3, 3, ExteriorVertex);
  EXPECT_TRUE(FindVoidsInCells(m_Volume).empty());
}
