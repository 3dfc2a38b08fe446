/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageFromText.h"
#include "TissueTessellationCore/Image/LabelIndexer.h"
#include "itkEnclosedVoidImageFilter.h"

#include <gtest/gtest.h>

using namespace tissue_test;

namespace
{
using FilterType = itk::EnclosedVoidImageFilter<TextImageType>;

const tissue::ExteriorLabels PointIsExterior{ true, '.', false };

/** The numbers of the voids as text, the rest as in the image. */
std::vector<std::string>
NumberVoids(const std::vector<std::string> & layers, itk::SizeValueType minimumNumberOfNeighbors = 4,
            itk::ThreadIdType workUnits = 1)
{
  const auto image = LabelImageFromText(layers);
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->SetExteriorLabels(&PointIsExterior);
  filter->SetMinimumNumberOfNeighbors(minimumNumberOfNeighbors);
  filter->SetNumberOfWorkUnits(workUnits);
  filter->Update();
  const auto numberOfVoxels = image->GetBufferedRegion().GetNumberOfPixels();
  for (itk::SizeValueType i = 0; i < numberOfVoxels; ++i)
  {
    const auto number = filter->GetOutput()->GetBufferPointer()[i];
    EXPECT_LE(number, filter->GetNumberOfVoids());
    if (number > 0)
    {
      image->GetBufferPointer()[i] = static_cast<unsigned char>('0' + number);
    }
  }
  return TextFromLabelImage(image);
}

/** Every piece of the exterior has a voxel on the border. */
const std::vector<std::string> Layers = { "aabbbbcc/aabbbbcc/aabbbbcc",
                                          "dd.bb.cc/dbbbbcc./d.bbbbb.",
                                          "eeffffgg/eeffffgg/eeffffgg" };
} // namespace

TEST(EnclosedVoidImageFilter, NumbersVoidsInRasterOrder)
{
  const std::vector<std::string> layers = { "aaaaaaa/aaaaaaa/aaaaaaa",
                                            "bbbbbbb/b.cc.db/bbbbbbb",
                                            "eeeeeee/eeeeeee/eeeeeee" };
  // The first has the neighbours a, b, c, e, the second a, b, c, d, e.
  EXPECT_EQ(NumberVoids(layers)[1], "bbbbbbb/b1cc2db/bbbbbbb");
  EXPECT_EQ(NumberVoids(layers, 5)[1], "bbbbbbb/b.cc1db/bbbbbbb");
  EXPECT_EQ(NumberVoids(layers, 6), layers);
  EXPECT_EQ(NumberVoids(layers, 4, 2), NumberVoids(layers, 4, 1));
}

TEST(EnclosedVoidImageFilter, APieceAtTheBorderIsOpen)
{
  EXPECT_EQ(NumberVoids(Layers), Layers);
}

TEST(EnclosedVoidImageFilter, VoxelsThatShareNoFaceAreTwoVoids)
{
  const std::vector<std::string> layers = { "aaaa/bbbb/cccc/dddd", "aaaa/b.cc/dd.b/aaaa", "aaaa/bbbb/cccc/dddd" };
  EXPECT_EQ(NumberVoids(layers, 3)[1], "aaaa/b1cc/dd2b/aaaa");
}

TEST(EnclosedVoidImageFilter, NeedsTheExteriorLabels)
{
  const auto filter = FilterType::New();
  filter->SetInput(LabelImageFromText(Layers));
  EXPECT_THROW(filter->Update(), itk::ExceptionObject);
}
