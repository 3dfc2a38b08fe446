/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/VoxelVertices.h"

#include <gtest/gtest.h>

#include <limits>

using namespace tissue;

namespace
{
/** The bytes of each number. */
std::size_t
WidthOf(const VoxelVertices & vertices)
{
  return vertices.Visit([](const auto * first) { return sizeof(*first); });
}
} // namespace

TEST(VoxelVertices, IsAListOfNumbers)
{
  VoxelVertices vertices;
  EXPECT_TRUE(vertices.empty());
  vertices.push_back(3);
  vertices.push_back(1);
  vertices.push_back(3);
  vertices.Put(1, 2);
  EXPECT_EQ(vertices, (VoxelVertices{ 3, 2, 3 }));
  vertices.Replace(3, 4);
  EXPECT_EQ(std::vector<VertexId>(vertices.begin(), vertices.end()), (std::vector<VertexId>{ 4, 2, 4 }));
  vertices.Fill(1, 3, 5);
  EXPECT_EQ(vertices, (std::vector<VertexId>{ 4, 5, 5 }));
  EXPECT_FALSE(vertices == VoxelVertices(3, 5));
  EXPECT_FALSE(vertices == VoxelVertices(2, 4));
}

TEST(VoxelVertices, TakesTwoBytesUpTo65535)
{
  VoxelVertices vertices(5, 65535);
  EXPECT_EQ(WidthOf(vertices), 2u);
  vertices.Put(2, 65536);
  EXPECT_EQ(WidthOf(vertices), 4u);
  EXPECT_EQ(vertices, (std::vector<VertexId>{ 65535, 65535, 65536, 65535, 65535 }));
  EXPECT_EQ(WidthOf(VoxelVertices(1, 0, 65536)), 4u);
}

TEST(VoxelVertices, KnowsAllNumbers)
{
  const std::vector<VertexId> numbers{ 0, -1, 65535, 65536, std::numeric_limits<VertexId>::max() };
  VoxelVertices               vertices;
  for (const VertexId v : numbers)
  {
    vertices.push_back(v);
  }
  EXPECT_EQ(vertices, numbers);
  EXPECT_EQ(VoxelVertices(numbers), numbers);
  EXPECT_EQ(VoxelVertices({ 70000, 1 }), (std::vector<VertexId>{ 70000, 1 })) << "with a large one first";
}
