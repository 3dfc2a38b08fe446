/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkTissueJunctions.h"
#include "itkTissueLabelVolume.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{
/** Of 2 x 3 x 1 voxels. */
itk::TissueLabelVolume::Pointer
MakeVolume()
{
  const auto labels = std::make_shared<tissue::LabelVolume>();
  labels->size = { { 2, 3, 1 } };
  labels->vertices = { 0, 1, 2, 0, 1, 2 };
  const auto volume = itk::TissueLabelVolume::New();
  volume->SetLabelVolume(labels);
  return volume;
}

std::string
Print(const itk::Object * object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}
} // namespace

TEST(TissueLabelVolume, IsEmptyAtFirstAndAfterInitialize)
{
  const auto volume = itk::TissueLabelVolume::New();
  EXPECT_EQ(volume->GetNumberOfVoxels(), 0u);
  EXPECT_THROW(volume->GetLabelVolume(), itk::ExceptionObject);
  const auto filled = MakeVolume();
  EXPECT_EQ(filled->GetNumberOfVoxels(), 6u);
  EXPECT_EQ(filled->GetLabelVolume().At(1, 0, 0), 1);
  filled->Initialize();
  EXPECT_EQ(filled->GetNumberOfVoxels(), 0u);
  EXPECT_THROW(filled->GetLabelVolume(), itk::ExceptionObject);
}

TEST(TissueLabelVolume, ANewVolumeModifiesIt)
{
  const auto volume = MakeVolume();
  const auto before = volume->GetMTime();
  volume->SetLabelVolume(std::make_shared<tissue::LabelVolume>());
  EXPECT_GT(volume->GetMTime(), before);
}

TEST(TissueLabelVolume, AGraftSharesTheVolume)
{
  const auto volume = MakeVolume();
  const auto other = itk::TissueLabelVolume::New();
  other->Graft(volume);
  EXPECT_EQ(&other->GetLabelVolume(), &volume->GetLabelVolume());
  volume->Initialize();
  EXPECT_EQ(other->GetNumberOfVoxels(), 6u);
  EXPECT_THROW(other->Graft(itk::TissueJunctions::New()), itk::ExceptionObject);
}

TEST(TissueLabelVolume, PrintsTheNumberOfItsVoxels)
{
  EXPECT_NE(Print(MakeVolume()).find("Voxels: 6"), std::string::npos);
  EXPECT_NE(Print(itk::TissueLabelVolume::New()).find("Voxels: 0"), std::string::npos);
}
