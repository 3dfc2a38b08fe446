/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

/* The extraction against its definition, and its determinism. */

namespace
{
using namespace tissue_test;
using ImageType = LabelImage<short>;
using FilterType = itk::LabelJunctionExtractionFilter<ImageType>;

/** The definition, word by word: the label of a voxel, 0 outside of the image. */
class SlowReference
{
public:
  std::map<std::set<long>, long> faces;
  /** Blocks by subset of three or four of their labels. */
  std::map<std::set<long>, long> blocks;
  std::map<std::set<long>, long> exactBlocks;
  long                           numberOfCrowdedBlocks = 0;

  explicit SlowReference(const ImageType * image)
    : m_Image(image)
  {
    const auto size = image->GetLargestPossibleRegion().GetSize();
    for (long z = 0; z <= static_cast<long>(size[2]); ++z)
    {
      for (long y = 0; y <= static_cast<long>(size[1]); ++y)
      {
        for (long x = 0; x <= static_cast<long>(size[0]); ++x)
        {
          this->Visit(x, y, z);
        }
      }
    }
  }

private:
  void
  Visit(long x, long y, long z)
  {
    for (const long other : { LabelAt(x - 1, y, z), LabelAt(x, y - 1, z), LabelAt(x, y, z - 1) })
    {
      if (other != LabelAt(x, y, z))
      {
        ++faces[{ other, LabelAt(x, y, z) }];
      }
    }
    std::set<long> block;
    for (int i = 0; i < 8; ++i)
    {
      block.insert(LabelAt(x - i % 2, y - i / 2 % 2, z - i / 4));
    }
    numberOfCrowdedBlocks += block.size() > 4;
    exactBlocks[block] += block.size() == 4;
    const std::vector<long> labels(block.begin(), block.end());
    for (unsigned int bits = 0; bits < 1u << labels.size(); ++bits)
    {
      std::set<long> subset;
      for (std::size_t i = 0; i < labels.size(); ++i)
      {
        if (bits & 1u << i)
        {
          subset.insert(labels[i]);
        }
      }
      if (subset.size() == 3 || subset.size() == 4)
      {
        ++blocks[subset];
      }
    }
  }

  long
  LabelAt(long x, long y, long z) const
  {
    const itk::Index<3> index = { { x, y, z } };
    return m_Image->GetLargestPossibleRegion().IsInside(index) ? m_Image->GetPixel(index) : 0;
  }

  const ImageType * m_Image;
};

template <typename TItem>
std::set<long>
LabelsOf(const TItem & item, const tissue::JunctionSet & set)
{
  std::set<long> labels;
  for (const tissue::VertexId cell : item.cells)
  {
    labels.insert(set.cells[cell].label);
  }
  return labels;
}

void
ExpectAsDefined(const ImageType * image)
{
  const SlowReference reference(image);
  const auto          set = Extract(image);
  EXPECT_EQ(set.numberOfCrowdedBlocks, reference.numberOfCrowdedBlocks);
  EXPECT_EQ(set.walls.size(), reference.faces.size());
  for (const tissue::Wall & wall : set.walls)
  {
    EXPECT_EQ(wall.numberOfFaces, reference.faces.at(LabelsOf(wall, set)));
  }
  EXPECT_EQ(set.tripleLines.size() + set.junctions.size(), reference.blocks.size());
  for (const tissue::TripleLine & line : set.tripleLines)
  {
    EXPECT_EQ(line.numberOfBlocks, reference.blocks.at(LabelsOf(line, set)));
  }
  for (const tissue::Junction & junction : set.junctions)
  {
    const auto labels = LabelsOf(junction, set);
    EXPECT_EQ(junction.numberOfBlocks, reference.blocks.at(labels));
    const auto exact = reference.exactBlocks.find(labels);
    EXPECT_EQ(junction.numberOfExactBlocks, exact == reference.exactBlocks.end() ? 0 : exact->second);
  }
  EXPECT_TRUE(std::is_sorted(
    set.junctions.begin(), set.junctions.end(), [](const auto & a, const auto & b) { return a.cells < b.cells; }));
}

FilterType::Pointer
MakeFilter(const ImageType * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}
} // namespace

TEST(LabelJunctionExtractionDefinition, HoldsOnNoise)
{
  ExpectAsDefined(MakeNoise<short>({ { 9, 7, 6 } }, 6, 1));
  ExpectAsDefined(MakeNoise<short>({ { 300, 5, 4 } }, 40, 2));
  ExpectAsDefined(MakeNoise<short>({ { 1, 6, 9 } }, 5, 3));
}

TEST(LabelJunctionExtractionDefinition, HoldsOnATissue)
{
  ExpectAsDefined(MakeBallTissue<short>(30, 4));
}

TEST(LabelJunctionExtractionDefinition, SameForAnyNumberOfThreads)
{
  const auto image = MakeBallTissue<short>(40, 5);
  const auto one = MakeFilter(image);
  one->SetNumberOfWorkUnits(1);
  one->Update();
  const tissue::JunctionSet & expected = one->GetOutput()->GetJunctionSet();
  for (const unsigned int threads : { 2u, 3u, 16u })
  {
    const auto filter = MakeFilter(image);
    filter->SetNumberOfWorkUnits(threads);
    filter->Update();
    const tissue::JunctionSet & set = filter->GetOutput()->GetJunctionSet();
    ASSERT_EQ(set.cells.size(), expected.cells.size());
    for (std::size_t i = 0; i < set.cells.size(); ++i)
    {
      EXPECT_EQ(set.cells[i].center, expected.cells[i].center);
      EXPECT_EQ(set.cells[i].numberOfPieces, expected.cells[i].numberOfPieces);
      EXPECT_EQ(set.cells[i].numberOfVoxels, expected.cells[i].numberOfVoxels);
    }
    ASSERT_EQ(set.walls.size(), expected.walls.size());
    for (std::size_t i = 0; i < set.walls.size(); ++i)
    {
      EXPECT_EQ(set.walls[i].cells, expected.walls[i].cells);
      EXPECT_EQ(set.walls[i].center, expected.walls[i].center);
      EXPECT_EQ(set.walls[i].area, expected.walls[i].area);
    }
    ASSERT_EQ(set.junctions.size(), expected.junctions.size());
    for (std::size_t i = 0; i < set.junctions.size(); ++i)
    {
      EXPECT_EQ(set.junctions[i].cells, expected.junctions[i].cells);
      EXPECT_EQ(set.junctions[i].position, expected.junctions[i].position);
      EXPECT_EQ(set.junctions[i].numberOfClusters, expected.junctions[i].numberOfClusters);
    }
  }
}
