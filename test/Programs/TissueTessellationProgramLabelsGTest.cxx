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

#include <algorithm>
#include <cmath>

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
  EXPECT_LT(closed["closedGaps"]["shareLeft"], 0.05);
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
  EXPECT_EQ(input["closedGaps"],
            Json({ { "width", 0.0 }, { "voxels", 0 }, { "largestDistance", 0.0 }, { "shareLeft", 0.0 } }));
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

TEST_F(TissueTessellationAppLabels, ExteriorOfSeveralLabelsIsOne)
{
  // The exterior is label 70, and in a corner label 900.
  const auto                                   image = MakeSyntheticTestTissue<unsigned short>();
  itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    const auto index = it.GetIndex();
    it.Set(it.Get() != ExteriorLabel ? it.Get() : index[0] + index[1] < 20 ? 900 : 70);
  }
  Json report = this->Report(image.GetPointer(), "--exteriorLabel 70 --exteriorLabel 900");
  EXPECT_EQ(report["input"]["cells"], 40);
  EXPECT_EQ(report["input"]["exteriorLabel"], 70);
  EXPECT_EQ(report["input"]["exteriorLabels"], Json({ 0, 70, 900 }));
  EXPECT_EQ(report["options"]["exteriorLabel"], Json({ 70, 900 }));
  EXPECT_NE(m_Output.find("40 cells, exterior label 70, 900\n"), std::string::npos) << m_Output;
  // The option takes one label, so that files may follow it.
  EXPECT_EQ(this->Run("--exteriorLabel 900 --exteriorLabel 70 tissue.mha walls.vtp"), 0) << m_Errors;

  report = this->Report(image.GetPointer());
  EXPECT_EQ(report["input"]["exteriorLabel"], 70);
  EXPECT_EQ(report["input"]["cells"], 41);
  EXPECT_EQ(report["input"]["suspects"], Json({ 900 }));
  EXPECT_NE(m_Errors.find("1 label may be no cell,"), std::string::npos) << m_Errors;
  for (const char * arguments : { "--dropCells suspects", "--dropCells 900", "--dropCells 900,suspects" })
  {
    report = this->Report(image.GetPointer(), arguments);
    EXPECT_EQ(report["input"]["cells"], 40) << arguments;
    EXPECT_EQ(report["input"]["droppedLabels"], Json({ 900 })) << arguments;
    EXPECT_NE(m_Output.find("dropped as no cells: 900\n"), std::string::npos) << m_Output;
  }
  this->ExpectRefusal("tissue.mha new.vtp --exteriorLabel 70 --exteriorLabel 71", { "71 is not a label" });
  this->ExpectRefusal("tissue.mha new.vtp --dropCells 71", { "to be dropped 71 is not a label" });
  this->ExpectRefusal("tissue.mha new.vtp --dropCells all", { "--dropCells", "all is neither a label" });
}

TEST_F(TissueTessellationAppLabels, ExteriorThatTheImageHasNotIsNamed)
{
  const auto cubes = tissue_test::MakeImage<unsigned short>(
    { { 12, 12, 12 } }, [](long x, long y, long z) { return 1 + x / 6 + 2 * (y / 6) + 4 * (z / 6); });
  this->Report(cubes.GetPointer());
  EXPECT_NE(m_Errors.find("no voxel of the image is exterior"), std::string::npos) << m_Errors;
  EXPECT_NE(m_Errors.find("which covers 13 % of the image's border"), std::string::npos) << m_Errors;
  this->Report(MakeSyntheticTestTissue<unsigned short>().GetPointer());
  EXPECT_EQ(m_Errors, "");
}

TEST_F(TissueTessellationAppLabels, StainsAreRefusedAsLabels)
{
  const auto noise = tissue_test::MakeNoise<unsigned short>({ { 16, 16, 16 } }, 200, 3);
  this->WriteImage(noise.GetPointer(), "noise.mha");
  this->ExpectRefusal("noise.mha walls.vtp", { "noise.mha", "200 of 200 labels are specks", "--membrane", "Nuclei" });
  // Such an image of the size that tests have is meshed if it must be.
  const auto small = tissue_test::MakeNoise<unsigned short>({ { 5, 5, 5 } }, 8, 3);
  this->WriteImage(small.GetPointer(), "small.mha");
  this->ExpectRefusal("small.mha walls.vtp", { "8 of 8 labels are specks" });
  EXPECT_EQ(this->Run("small.mha walls.vtp --acceptSpecks --exteriorLabel 1"), 0) << m_Errors;
}

TEST_F(TissueTessellationAppLabels, GapsThatRemainAreNamed)
{
  // Balls of 6 voxels, 4 apart.
  const auto nuclei = tissue_test::MakeImage<unsigned short>({ { 36, 36, 36 } }, [](long x, long y, long z) {
    const auto away = [](long i) { return static_cast<double>((i - 3) % 10) - 4.5; };
    const bool isIn = std::min({ x, y, z }) >= 3 && std::max({ x, y, z }) < 33;
    return isIn && std::hypot(away(x), away(y), away(z)) < 3.0
             ? 1 + (x - 3) / 10 + 3 * ((y - 3) / 10) + 9 * ((z - 3) / 10)
             : 0;
  });
  this->WriteImage(nuclei.GetPointer(), "nuclei.mha");
  EXPECT_EQ(this->Run("nuclei.mha walls.vtp --closeGaps=4"), 0) << m_Errors;
  EXPECT_NE(m_Errors.find("gaps remain between cells"), std::string::npos) << m_Errors;
  EXPECT_EQ(this->Run("nuclei.mha walls.vtp --closeGaps=16"), 0) << m_Errors;
  EXPECT_EQ(m_Errors.find("gaps remain"), std::string::npos) << m_Errors;
}

TEST_F(TissueTessellationAppLabels, HolesInCellsAreKeptAndNamed)
{
  // Eight cubes of 8 voxels, the fifth with a hole of 2.
  const auto cubes = tissue_test::MakeImage<unsigned short>({ { 20, 20, 20 } }, [](long x, long y, long z) {
    const auto isIn = [](long i) { return i >= 2 && i < 18; };
    const bool isHole = x / 2 == 3 && y / 2 == 3 && z / 2 == 7;
    return isIn(x) && isIn(y) && isIn(z) && !isHole ? 1 + x / 10 + 2 * (y / 10) + 4 * (z / 10) : 0;
  });
  const Json report = this->Report(cubes.GetPointer());
  EXPECT_EQ(LabelsOf(report, "cavities"), std::set<long>{ 5 });
  EXPECT_EQ(report["input"]["voids"], 1);
}

TEST_F(TissueTessellationAppLabels, LastLinesTellHowGoodTheMeshIs)
{
  this->Report(MakeSyntheticTestTissue<unsigned short>().GetPointer(), "--strict");
  const std::size_t last =
    m_Output.find("Closed spheres: 40 of 40 cells; pairs of triangles that cross: 0\nVolumes: mean ");
  ASSERT_NE(last, std::string::npos) << m_Output;
  EXPECT_NE(m_Output.find("adjacency4 0.", last), std::string::npos) << m_Output;
  EXPECT_NE(m_Output.find("\nWorst remark: ", last), std::string::npos) << m_Output;
  EXPECT_EQ(std::count(m_Output.begin() + static_cast<std::ptrdiff_t>(last), m_Output.end(), '\n'), 3);
}

TEST_F(TissueTessellationAppLabels, FaultsAreWarningsAndEndAStrictRunWithTwo)
{
  // Stars that are not fitted do not have the cells' volumes.
  this->WriteTissue<unsigned short>("tissue.mha");
  const std::string arguments = "tissue.mha walls.vtp --preset paper --report report.json";
  EXPECT_EQ(this->Run(arguments), 0);
  EXPECT_NE(m_Errors.find("more than 5 % off their volume"), std::string::npos) << m_Errors;
  EXPECT_FALSE(this->ReadReport()["faults"].empty());
  EXPECT_EQ(this->Run(arguments + " --strict"), 2);
  EXPECT_NE(m_Errors.find("--strict: the mesh is written, but has faults"), std::string::npos) << m_Errors;
  EXPECT_EQ(this->List(), "report.json tissue.mha walls.vtp ");
}

TEST_F(TissueTessellationAppLabels, ProgressIsThereAsLinesOnRequest)
{
  this->WriteTissue<unsigned short>("tissue.mha");
  EXPECT_EQ(this->Run("tissue.mha walls.vtp --progress lines --quiet"), 0) << m_Errors;
  std::size_t at = 0;
  for (const char * phase :
       { "Reading", "Finding junctions", "Finding the complex", "Making the walls", "Fitting the walls", "Writing" })
  {
    const std::size_t found = m_Errors.find(std::string(" s: ") + phase + ", ", at);
    ASSERT_NE(found, std::string::npos) << phase << " in " << m_Errors;
    at = found;
  }
  this->ExpectRefusal("tissue.mha new.vtp --progress much", { "--progress" });
}
