/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Label images that are not as one would wish.
#include "LabelImageTestHelpers.h"
#include "TissueTessellationProgramTest.h"

#include <itkImageRegionIterator.h>
#include <itkImageRegionIteratorWithIndex.h>
#include <itkRegionOfInterestImageFilter.h>

namespace
{
using Json = nlohmann::json;
using ImageType = itk::Image<unsigned short, 3>;
using IndexType = ImageType::IndexType;

constexpr unsigned short ExteriorLabel = 0;

class TissueTessellationAppLabels : public TissueTessellationAppTest
{
protected:
  /** Runs the program on the image and returns the report. */
  template <typename TImage>
  Json
  Report(const TImage * image, const std::string & arguments = "")
  {
    this->WriteImage(image, "tissue.mha");
    const int exitCode = this->Run("tissue.mha walls.vtp --report report.json " + arguments);
    EXPECT_EQ(exitCode, 0) << m_Errors;
    return exitCode == 0 ? this->ReadReport() : Json();
  }
};

/** Puts voxels of background, of value 0, where a cell has another one next to it in the direction of an axis. */
std::size_t
Erode(ImageType * image, unsigned short exterior)
{
  std::vector<IndexType>                            eroded;
  const auto                                        region = image->GetLargestPossibleRegion();
  itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, region);
  for (; !it.IsAtEnd(); ++it)
  {
    bool isWall = false;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      IndexType next = it.GetIndex();
      ++next[axis];
      isWall = isWall || (region.IsInside(next) && image->GetPixel(next) != it.Get() && it.Get() != exterior &&
                          image->GetPixel(next) != exterior);
    }
    if (isWall)
    {
      eroded.push_back(it.GetIndex());
    }
  }
  for (const IndexType & index : eroded)
  {
    image->SetPixel(index, 0);
  }
  return eroded.size();
}

/** A voxel amid voxels of its own cell. */
IndexType
FindInnerVoxel(const ImageType * image)
{
  ImageType::RegionType inside = image->GetLargestPossibleRegion();
  inside.ShrinkByRadius(1);
  itk::ImageRegionConstIteratorWithIndex<ImageType> it(image, inside);
  for (; !it.IsAtEnd(); ++it)
  {
    bool isInner = it.Get() != ExteriorLabel;
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      for (const int step : { -1, 1 })
      {
        IndexType next = it.GetIndex();
        next[axis] += step;
        isInner = isInner && image->GetPixel(next) == it.Get();
      }
    }
    if (isInner)
    {
      break;
    }
  }
  return it.GetIndex();
}
} // namespace

TEST_F(TissueTessellationAppLabels, ErodedCellsAreRefusedAndClosedOnRequest)
{
  const auto        image = MakeSyntheticTestTissue<unsigned short>();
  const std::size_t numberOfEroded = Erode(image, ExteriorLabel);
  this->WriteImage(image.GetPointer(), "tissue.mha");
  EXPECT_EQ(this->Run("tissue.mha walls.vtp"), 1);
  EXPECT_NE(m_Errors.find("40 of 40 cells touch no other cell"), std::string::npos) << m_Errors;
  EXPECT_NE(m_Errors.find("--closeGaps"), std::string::npos) << m_Errors;
  EXPECT_EQ(this->List(), "tissue.mha ");

  const Json closed = this->Report(image.GetPointer(), "--closeGaps")["input"];
  EXPECT_EQ(closed["cells"], 40);
  EXPECT_GE(closed["closedGaps"]["width"], 0.5);
  EXPECT_GE(closed["closedGaps"]["voxels"].get<double>(), 0.95 * numberOfEroded);
  EXPECT_LE(closed["closedGaps"]["largestDistance"], closed["closedGaps"]["width"]);
  EXPECT_NE(m_Output.find("voxels given to cells"), std::string::npos) << m_Output;
}

TEST_F(TissueTessellationAppLabels, GapsWiderThanAskedForAreRefusedByTheirWidth)
{
  // Eight cubes of seven voxels, labels 1 to 8, with two voxels of background between them.
  const auto cubes = tissue_test::MakeImage<unsigned short>({ { 20, 20, 20 } }, [](long x, long y, long z) {
    const auto isIn = [](long i) { return i >= 2 && i < 18 && i != 9 && i != 10; };
    return isIn(x) && isIn(y) && isIn(z) ? 1 + x / 10 + 2 * (y / 10) + 4 * (z / 10) : 0;
  });
  this->WriteImage(cubes.GetPointer(), "tissue.mha");
  EXPECT_EQ(this->Run("tissue.mha walls.vtp --closeGaps=0.5"), 1);
  EXPECT_NE(m_Errors.find("wider than the gaps that --closeGaps has closed, of 0.5"), std::string::npos) << m_Errors;
  EXPECT_EQ(this->Run("tissue.mha walls.vtp --closeGaps=3"), 0) << m_Errors;
}

TEST_F(TissueTessellationAppLabels, GapsAreClosedBesideAnExteriorOfAnotherLabel)
{
  constexpr unsigned short            exterior = 99;
  const auto                          image = MakeSyntheticTestTissue<unsigned short>();
  itk::ImageRegionIterator<ImageType> it(image, image->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    it.Set(it.Get() == ExteriorLabel ? exterior : it.Get());
  }
  const std::size_t numberOfEroded = Erode(image, exterior);
  for (const char * arguments : { "--closeGaps", "--closeGaps --exteriorLabel 99" })
  {
    const Json input = this->Report(image.GetPointer(), arguments)["input"];
    EXPECT_EQ(input["cells"], 40) << arguments;
    EXPECT_EQ(input["exteriorLabel"], exterior) << arguments;
    EXPECT_GE(input["closedGaps"]["voxels"].get<double>(), 0.95 * numberOfEroded) << arguments;
  }
}

TEST_F(TissueTessellationAppLabels, ClosingFindsNoGapsWhereThereAreNone)
{
  // Eight cubes of four voxels, labels 1 to 8.
  const auto cubes = tissue_test::MakeImage<unsigned short>({ { 12, 12, 12 } }, [](long x, long y, long z) {
    const auto isIn = [](long i) { return i >= 2 && i < 10; };
    return isIn(x) && isIn(y) && isIn(z) ? 1 + x / 6 + 2 * (y / 6) + 4 * (z / 6) : 0;
  });
  const Json input = this->Report(cubes.GetPointer(), "--closeGaps")["input"];
  EXPECT_EQ(input["cells"], 8);
  EXPECT_EQ(input["closedGaps"], Json({ { "width", 0.0 }, { "voxels", 0 }, { "largestDistance", 0.0 } }));
}

TEST_F(TissueTessellationAppLabels, OddCellsAreInTheMeshAndNamed)
{
  const auto image = MakeSyntheticTestTissue<unsigned short>();
  // In a dome, the corners of the image's top are exterior.
  for (const IndexType & corner : { IndexType{ { 2, 2, 15 } }, IndexType{ { 37, 37, 15 } } })
  {
    ASSERT_EQ(image->GetPixel(corner), ExteriorLabel);
  }
  image->SetPixel({ { 2, 2, 15 } }, 7);
  image->SetPixel({ { 37, 37, 15 } }, 150);
  image->SetPixel(FindInnerVoxel(image), 200);
  const Json report = this->Report(image.GetPointer());
  EXPECT_EQ(LabelsOf(report, "severalPieces"), std::set<long>{ 7 });
  EXPECT_EQ(LabelsOf(report, "separated"), std::set<long>{ 150 });
  EXPECT_EQ(LabelsOf(report, "enclosed"), std::set<long>{ 200 });
  EXPECT_EQ(LabelsOf(report, "cutByBorder"), std::set<long>{});
  EXPECT_EQ(report["input"]["cells"], 42);
  EXPECT_EQ(report["mesh"]["cellsWithoutTriangles"], Json::array());
  EXPECT_NE(m_Output.find("1 in several pieces; the largest counts: 7\n"), std::string::npos) << m_Output;
  EXPECT_NE(m_Output.find("1 enclosed in one other cell: 200\n"), std::string::npos) << m_Output;
}

TEST_F(TissueTessellationAppLabels, CellsCutByTheBorderAreClosedThere)
{
  const auto block = itk::RegionOfInterestImageFilter<ImageType, ImageType>::New();
  block->SetInput(MakeSyntheticTestTissue<unsigned short>());
  block->SetRegionOfInterest(ImageType::RegionType({ { 8, 8, 2 } }, { { 24, 24, 10 } }));
  block->Update();
  const Json report = this->Report(block->GetOutput());
  EXPECT_GE(LabelsOf(report, "cutByBorder").size(), 10u);
  EXPECT_EQ(report["mesh"]["cellsThatAreNoClosedSphere"], Json::array());
}

TEST_F(TissueTessellationAppLabels, GapsInTheIdsChangeNothingElse)
{
  using WideImageType = itk::Image<long long, 3>;
  const Json                              dense = this->Report(MakeSyntheticTestTissue<unsigned short>().GetPointer());
  const auto                              sparse = MakeSyntheticTestTissue<long long>();
  itk::ImageRegionIterator<WideImageType> it(sparse, sparse->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    it.Set(it.Get() == ExteriorLabel ? ExteriorLabel : 10000000019 * it.Get() - 200000000000);
  }
  const Json report = this->Report(sparse.GetPointer());
  EXPECT_EQ(report["stages"], dense["stages"]);
  std::set<long> labels;
  for (const long label : LabelsOf(dense, "wallsLost"))
  {
    labels.insert(10000000019 * label - 200000000000);
  }
  EXPECT_EQ(LabelsOf(report, "wallsLost"), labels);
}
