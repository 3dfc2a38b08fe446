/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageFromText.h"
#include "LabelImageTestHelpers.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkCommand.h"

#include <gtest/gtest.h>

#include <string>

/* Cells in pieces or cut by the border, the label volume, and errors. */

namespace
{
using namespace tissue_test;
using ImageType = LabelImage<short>;
using FilterType = itk::LabelJunctionExtractionFilter<ImageType>;

FilterType::Pointer
MakeFilter(const ImageType * image)
{
  const auto filter = FilterType::New();
  filter->SetInput(image);
  return filter;
}

/** What an error says, or nothing if there is none. */
std::string
ErrorOf(FilterType * filter)
{
  try
  {
    filter->Update();
  }
  catch (const itk::ExceptionObject & error)
  {
    return error.GetDescription();
  }
  return "";
}

constexpr auto Has = [](const std::string & text, const char * part) { return text.find(part) != std::string::npos; };
} // namespace

// Values derived by hand. A U of label 50 lies across all planes: its arms join in the last plane only.
TEST(LabelJunctionExtractionPieces, AreJoinedAcrossThreadsAndCounted)
{
  const auto image = MakeFourCubes<short>();
  for (long z = 0; z < 8; ++z)
  {
    image->SetPixel({ { 0, 0, z } }, 50);
    image->SetPixel({ { 2, 0, z } }, 50);
  }
  image->SetPixel({ { 1, 0, 7 } }, 50);
  // A fragment of three voxels, and a void of the exterior in a cell; edges do not connect.
  for (long x = 9; x < 12; ++x)
  {
    image->SetPixel({ { x, 11, 0 } }, 50);
  }
  image->SetPixel({ { 4, 4, 4 } }, 0);
  for (const unsigned int threads : { 1u, 4u })
  {
    const auto filter = MakeFilter(image);
    filter->SetNumberOfWorkUnits(threads);
    filter->Update();
    const auto & cells = filter->GetOutput()->GetJunctionSet().cells;
    ASSERT_EQ(cells.size(), 6u);
    EXPECT_EQ(cells[5].numberOfPieces, 2);
    EXPECT_EQ(cells[5].numberOfVoxels, 20);
    EXPECT_EQ(cells[5].numberOfStrayVoxels, 3);
    EXPECT_TRUE(cells[5].touchesBorder);
    EXPECT_NEAR(cells[5].center[0], 1.0, 1e-12);
    EXPECT_NEAR(cells[5].center[1], 0.0, 1e-12);
    EXPECT_NEAR(cells[5].center[2], (16 * 3.5 + 7) / 17, 1e-12);
    EXPECT_EQ(cells[0].numberOfPieces, 2);
    EXPECT_EQ(cells[0].numberOfStrayVoxels, 1);
    EXPECT_EQ(cells[1].numberOfVoxels, 63);
  }
}

TEST(LabelJunctionExtractionPieces, OnlyCellsOfTheBorderTouchIt)
{
  const auto set = Extract(MakeImage<short>({ { 9, 9, 9 } }, [](long x, long y, long z) {
                             return 1 + x / 3 + 3 * (y / 3) + 9 * (z / 3);
                           }).GetPointer());
  ASSERT_EQ(set.cells.size(), 28u);
  for (int i = 1; i <= 27; ++i)
  {
    EXPECT_EQ(set.cells[i].touchesBorder, i != 14) << i;
    EXPECT_EQ(set.cells[i].touchesExterior, i != 14) << i;
  }
  EXPECT_EQ(set.cells[0].numberOfVoxels, 0);
}

TEST(LabelJunctionExtractionVotes, AreOnTheVerticesOfTheirLabels)
{
  const auto image = LabelImageFromText({ "...../.adf./...../" });
  const auto filter = itk::LabelJunctionExtractionFilter<TextImageType>::New();
  filter->SetInput(image);
  filter->SetExteriorLabel('.');
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetJunctionSet().votes.empty());
  const auto votes = itk::TissueVotes::New();
  votes->SetVotes({ { { { 0, 'a', 'd', 'f' } }, 0.5 } });
  filter->SetVotes(votes);
  filter->Update();
  const auto & found = filter->GetOutput()->GetJunctionSet().votes;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].cells, (tissue::VertexQuadruple{ { 0, 1, 2, 3 } }));
  EXPECT_EQ(found[0].share, 0.5);
}

TEST(LabelJunctionExtractionVotes, OnALabelThatIsNoCellAreRefused)
{
  const auto filter = MakeFilter(MakeFourCubes<short>());
  const auto votes = itk::TissueVotes::New();
  votes->SetVotes({ { { { 0, 10, 20, 21 } }, 0.5 } });
  filter->SetVotes(votes);
  const std::string error = ErrorOf(filter);
  EXPECT_TRUE(Has(error, "A vote is on label")) << error;
}

TEST(LabelJunctionExtractionVolume, IsMadeOnlyWhereAskedFor)
{
  const auto filter = MakeFilter(MakeFourCubes<short>());
  EXPECT_FALSE(filter->GetGenerateLabelVolume());
  filter->Update();
  EXPECT_EQ(filter->GetLabelVolume()->GetNumberOfVoxels(), 0u);
  filter->GenerateLabelVolumeOn();
  filter->Update();
  EXPECT_EQ(filter->GetLabelVolume()->GetNumberOfVoxels(), 12u * 12u * 8u);
  filter->GenerateLabelVolumeOff();
  filter->Update();
  EXPECT_EQ(filter->GetLabelVolume()->GetNumberOfVoxels(), 0u) << "of the run before";
}

TEST(LabelJunctionExtractionVolume, HasTheVertexOfEachVoxelAtItsPlace)
{
  const itk::Index<3>      start = { { 3, -2, 5 } };
  const auto               image = MakeFourCubes<short>(0, start);
  const double             spacing[] = { 0.5, 2.0, 1.0 };
  const double             origin[] = { 3.0, -7.0, 11.0 };
  ImageType::DirectionType direction;
  direction.SetIdentity();
  direction[0][0] = direction[1][1] = 0.0;
  direction[0][1] = -1.0;
  direction[1][0] = 1.0;
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  const auto filter = MakeFilter(image);
  filter->GenerateLabelVolumeOn();
  filter->Update();
  const tissue::LabelVolume & volume = filter->GetLabelVolume()->GetLabelVolume();
  const auto &                cells = filter->GetOutput()->GetJunctionSet().cells;
  ASSERT_EQ(volume.size, (std::array<std::int32_t, 3>{ { 12, 12, 8 } }));
  for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    const auto            index = it.GetIndex() - start;
    const tissue::Point   ofVolume = volume.ToPhysical({ { double(index[0]), double(index[1]), double(index[2]) } });
    itk::Point<double, 3> ofImage;
    image->TransformIndexToPhysicalPoint(it.GetIndex(), ofImage);
    const auto vertex = volume.At(
      static_cast<std::int32_t>(index[0]), static_cast<std::int32_t>(index[1]), static_cast<std::int32_t>(index[2]));
    ASSERT_EQ(cells[vertex].label, it.Get());
    ASSERT_NEAR(tissue::Distance(ofVolume, { { ofImage[0], ofImage[1], ofImage[2] } }), 0.0, 1e-12);
  }
}

// Two voids, of one and of two voxels.
TEST(LabelJunctionExtractionVolume, VoidsAreExterior)
{
  const auto image =
    LabelImageFromText({ "aaaaaaa/aaaaaaa/aaaaaaa", "bbbbbbb/b.cc..d/bbbbbbb", "eeeeeee/eeeeeee/eeeeeee" });
  const auto filter = itk::LabelJunctionExtractionFilter<TextImageType>::New();
  filter->SetInput(image);
  filter->SetExteriorLabel('.');
  filter->GenerateLabelVolumeOn();
  filter->Update();
  const tissue::Cell & exterior = filter->GetOutput()->GetJunctionSet().cells[tissue::ExteriorVertex];
  EXPECT_EQ(exterior.numberOfVoxels, 3);
  EXPECT_EQ(exterior.numberOfPieces, 3) << "with the outside of the image";
  for (const std::int32_t x : { 1, 4, 5 })
  {
    EXPECT_EQ(filter->GetLabelVolume()->GetLabelVolume().At(x, 1, 1), tissue::ExteriorVertex);
  }
}

TEST(LabelJunctionExtractionErrors, NoCell)
{
  const auto image = MakeFourCubes<short>();
  image->FillBuffer(7);
  const auto filter = MakeFilter(image);
  filter->SetExteriorLabel(7);
  const std::string error = ErrorOf(filter);
  EXPECT_TRUE(Has(error, "no cell") && Has(error, "exterior label is 7")) << error;
}

TEST(LabelJunctionExtractionErrors, AbsentExteriorLabel)
{
  const auto filter = MakeFilter(MakeFourCubes<short>());
  filter->SetExteriorLabel(1000000);
  const std::string error = ErrorOf(filter);
  EXPECT_TRUE(Has(error, "1000000") && Has(error, "4 labels")) << error;
}

TEST(LabelJunctionExtractionErrors, LabelAboveTheRange)
{
  using WideType = LabelImage<unsigned long long>;
  const auto image = MakeFourCubes<unsigned long long>();
  image->SetPixel({ { 3, 3, 3 } }, 1ULL << 63);
  const auto filter = itk::LabelJunctionExtractionFilter<WideType>::New();
  filter->SetInput(image);
  for (const unsigned int threads : { 1u, 8u })
  {
    filter->SetNumberOfWorkUnits(threads);
    EXPECT_THROW(filter->Update(), itk::ExceptionObject);
  }
}

TEST(LabelJunctionExtractionErrors, AbortStopsAndProgressEndsAtOne)
{
  const auto filter = MakeFilter(MakeBallTissue<short>(40, 6));
  filter->Update();
  EXPECT_FLOAT_EQ(filter->GetProgress(), 1.0f);

  const auto abort = itk::SimpleMemberCommand<FilterType>::New();
  abort->SetCallbackFunction(filter, &FilterType::AbortGenerateDataOn);
  filter->AddObserver(itk::ProgressEvent(), abort);
  filter->Modified();
  EXPECT_THROW(filter->Update(), itk::ProcessAborted);
}
