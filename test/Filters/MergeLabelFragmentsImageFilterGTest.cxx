/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageFromText.h"
#include "itkMergeLabelFragmentsImageFilter.h"

#include <gtest/gtest.h>

namespace
{
using namespace tissue_test;
using Layers = std::vector<std::string>;

struct Merged
{
  Layers             layers;
  itk::SizeValueType changes;
};

/** The exterior is '.'. */
Merged
Merge(const Layers & layers)
{
  auto filter = itk::MergeLabelFragmentsImageFilter<TextImageType>::New();
  filter->SetInput(LabelImageFromText(layers));
  filter->SetExteriorLabel('.');
  filter->Update();
  return { TextFromLabelImage(filter->GetOutput()), filter->GetNumberOfChangedVoxels() };
}
} // namespace

TEST(MergeLabelFragmentsImageFilter, LeavesWholeCellsAlone)
{
  // b is one piece by way of the second layer.
  const Layers layers = { "bab/bab", "bbb/ccc" };
  EXPECT_EQ(Merge(layers).layers, layers);
  EXPECT_EQ(Merge(layers).changes, 0u);
}

TEST(MergeLabelFragmentsImageFilter, FragmentGoesToTheNeighbourOfMostFaces)
{
  EXPECT_EQ(Merge({ "aabcc/aabac/aabcc" }).layers, (Layers{ "aabcc/aabcc/aabcc" }));
  EXPECT_EQ(Merge({ "aabbb/aabac/aabbb" }).layers, (Layers{ "aabbb/aabbc/aabbb" }));
}

TEST(MergeLabelFragmentsImageFilter, TiesGoToTheLeastLabelAndTheFirstPiece)
{
  EXPECT_EQ(Merge({ "ccbabaa" }).layers, (Layers{ "ccbbaaa" })) << "of the two b the first stays";
  EXPECT_EQ(Merge({ "aacabbb" }).layers, (Layers{ "aacbbbb" }));
}

TEST(MergeLabelFragmentsImageFilter, VoxelsThatTouchByAnEdgeAreApart)
{
  // Two pieces of b, and a single a at the corner of the first.
  EXPECT_EQ(Merge({ "aab/aab/bba" }).layers, (Layers{ "aab/aab/aab" }));
}

TEST(MergeLabelFragmentsImageFilter, FragmentWithinAFragmentFollowsIt)
{
  // The ring of a on the right falls to b, and the c within it after it.
  const Merged nested = Merge({ "cccaaaaabbbbb/cccaaaaabaaab/cccaaaaabacab/cccaaaaabaaab/cccaaaaabbbbb" });
  EXPECT_EQ(nested.layers, (Layers{ "cccaaaaabbbbb/cccaaaaabbbbb/cccaaaaabbbbb/cccaaaaabbbbb/cccaaaaabbbbb" }));
  EXPECT_EQ(nested.changes, 9u);
}

TEST(MergeLabelFragmentsImageFilter, ExteriorKeepsWhatTouchesTheBorderAndLosesItsVoids)
{
  EXPECT_EQ(Merge({ "....", "....", "...." }).changes, 0u);
  EXPECT_EQ(Merge({ ".aaa/aaaa/aaa.", ".aaa/aaaa/aaa.", ".aaa/aaaa/aaa." }).changes, 0u) << "two pieces at the border";
  EXPECT_EQ(Merge({ "aaa/aaa/aaa", "aaa/a.a/aaa", "aaa/aaa/aaa" }).layers,
            (Layers{ "aaa/aaa/aaa", "aaa/aaa/aaa", "aaa/aaa/aaa" }));
}

TEST(MergeLabelFragmentsImageFilter, FragmentInTheExteriorBecomesExterior)
{
  EXPECT_EQ(Merge({ "aa..a../aa....." }).layers, (Layers{ "aa...../aa....." }));
}
