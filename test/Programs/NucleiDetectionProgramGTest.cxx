/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The program for nuclei, from end to end.
#include "Shared/Points/PointFileReader.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationProgramTest.h"

#include <itkDiscreteGaussianImageFilter.h>
#include <itkImageRegionIteratorWithIndex.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace
{
using StainType = itk::Image<float, 3>;
const std::string Synthetic = "--size 64 64 40 --spacing 0.5 0.5 1 --cells 40 --quiet";

class NucleiDetectionApp : public TissueTessellationAppTest
{
protected:
  NucleiDetectionApp() { m_Program = NUCLEI_DETECTION_PROGRAM; }

  /** The stained nuclei of a small tissue, `nuclei.mha`, and where they are. */
  std::vector<tissue::Point>
  MakeNuclei()
  {
    m_Program = SYNTHETIC_TISSUE_PROGRAM;
    EXPECT_EQ(this->Run("labels.mha --nuclei nuclei.mha --nucleiPoints known.csv " + Synthetic), 0) << m_Errors;
    m_Program = NUCLEI_DETECTION_PROGRAM;
    const std::vector<tissue::Point> points = tissue::ReadPointFile(this->PathOf("known.csv")).points;
    for (const char * name : { "labels.mha", "known.csv" })
    {
      std::filesystem::remove(this->PathOf(name));
    }
    return points;
  }

  /** A blob in the middle of 20 x 20 x 20 voxels, changed. */
  void
  WriteStain(
    const std::string & name, const std::function<void(StainType *)> & change = [](StainType *) {})
  {
    const auto image = StainType::New();
    image->SetRegions(itk::Size<3>{ { 20, 20, 20 } });
    image->Allocate();
    for (itk::ImageRegionIteratorWithIndex<StainType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
    {
      double r2 = 0.0;
      for (unsigned int i = 0; i < 3; ++i)
      {
        r2 += std::pow(static_cast<double>(it.GetIndex()[i]) - 9.5, 2);
      }
      it.Set(static_cast<float>(100.0 * std::exp(-0.5 * r2 / 9.0)));
    }
    change(image);
    this->WriteImage(image.GetPointer(), name);
  }
};
} // namespace

TEST_F(NucleiDetectionApp, FindsTheNucleiOfASyntheticTissue)
{
  const std::vector<tissue::Point> known = this->MakeNuclei();
  ASSERT_EQ(known.size(), 40u);
  ASSERT_EQ(this->Run("nuclei.mha points.csv"), 0) << m_Errors;
  EXPECT_EQ(this->List(), "nuclei.mha points.csv ");
  EXPECT_EQ(ReadBytes(this->PathOf("points.csv")).rfind("x,y,z,Label,scale,radius,response\n", 0), 0u);
  EXPECT_EQ(m_Output.rfind("points.csv: 40 nuclei of scales from ", 0), 0u) << m_Output;
  EXPECT_EQ(m_Errors, "");
  const auto found = tissue::ReadPointFile(this->PathOf("points.csv"));
  ASSERT_EQ(found.points.size(), 40u);
  EXPECT_EQ(found.labels.front(), 1);
  EXPECT_EQ(found.labels.back(), 40);
  for (const tissue::Point & nucleus : known)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const tissue::Point & point : found.points)
    {
      least = std::min(least, tissue::Distance(nucleus, point));
    }
    EXPECT_LT(least, 1.0);
  }
}

TEST_F(NucleiDetectionApp, WritesTheSamePointsInEveryFormatAndWithAPicture)
{
  this->MakeNuclei();
  std::vector<std::vector<tissue::Point>> points;
  for (const char * file : { "a.csv", "a.fcsv", "a.mrk.json", "a.vtp" })
  {
    ASSERT_EQ(this->Run(std::string("nuclei.mha ") + file + " --quiet --picture " + file + ".png"), 0) << m_Errors;
    EXPECT_EQ(m_Output + m_Errors, "");
    points.push_back(tissue::ReadPointFile(this->PathOf(file)).points);
    EXPECT_EQ(points.back(), points.front()) << file;
    const std::string picture = ReadBytes(this->PathOf(std::string(file) + ".png"));
    EXPECT_EQ(picture.substr(1, 3), "PNG") << file;
    EXPECT_EQ(picture, ReadBytes(this->PathOf("a.csv.png"))) << file;
  }
  EXPECT_EQ(points.front().size(), 40u);
  EXPECT_EQ(this->List(), "a.csv a.csv.png a.fcsv a.fcsv.png a.mrk.json a.mrk.json.png a.vtp a.vtp.png nuclei.mha ");
}

TEST_F(NucleiDetectionApp, HasTheSameBytesForAnyNumberOfThreads)
{
  this->MakeNuclei();
  ASSERT_EQ(this->Run("nuclei.mha one.csv --threads 1"), 0) << m_Errors;
  ASSERT_EQ(this->Run("nuclei.mha three.csv --threads 3"), 0) << m_Errors;
  EXPECT_EQ(ReadBytes(this->PathOf("one.csv")), ReadBytes(this->PathOf("three.csv")));
}

TEST_F(NucleiDetectionApp, SpacingTakesThePlaceOfTheFiles)
{
  this->WriteStain("blob.mha");
  ASSERT_EQ(this->Run("blob.mha a.csv --threshold 20"), 0) << m_Errors;
  ASSERT_EQ(this->Run("blob.mha b.csv --threshold 20 --spacing 2 2 2"), 0) << m_Errors;
  const auto a = tissue::ReadPointFile(this->PathOf("a.csv")).points;
  const auto b = tissue::ReadPointFile(this->PathOf("b.csv")).points;
  ASSERT_EQ(a.size(), 1u);
  ASSERT_EQ(b.size(), 1u);
  EXPECT_NEAR(a[0][2], 9.5, 0.1);
  EXPECT_NEAR(b[0][2], 19.0, 0.2);
}

TEST_F(NucleiDetectionApp, WarnsWhereThereAreNoNuclei)
{
  this->WriteStain("slope.mha", [](StainType * image) {
    for (itk::ImageRegionIteratorWithIndex<StainType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
    {
      it.Set(static_cast<float>(it.GetIndex()[0]));
    }
  });
  for (const char * options : { "", " --quiet" })
  {
    ASSERT_EQ(
      this->Run(std::string("slope.mha points.csv --spacing 1 1 1 --minimumScale 1 --maximumScale 4 --threshold 0.5") +
                options),
      0);
    EXPECT_EQ(m_Errors,
              "NucleiDetection: warning: slope.mha: no nuclei of scales from 1 to 4 with a response of 0.5 or more\n");
    EXPECT_EQ(ReadBytes(this->PathOf("points.csv")), "x,y,z,Label,scale,radius,response\n");
  }
  ASSERT_EQ(this->Run("slope.mha points.csv --spacing 1 1 1"), 0);
  EXPECT_EQ(m_Errors, "NucleiDetection: warning: slope.mha: no nuclei, nor any blob that tells their scales\n");
}

TEST_F(NucleiDetectionApp, SaysThatNoiseIsNoise)
{
  std::mt19937                     random(2);
  std::normal_distribution<double> normal(40.0, 10.0);
  const auto                       fill = [&](StainType * image) {
    std::generate_n(image->GetBufferPointer(), 8000, [&] { return static_cast<float>(normal(random)); });
  };
  this->WriteStain("noise.mha", fill);
  ASSERT_EQ(this->Run("noise.mha points.csv"), 0);
  EXPECT_NE(m_Errors.find("no nuclei, nor any blob that tells their scales and exceeds the noise, of deviation "),
            std::string::npos)
    << m_Errors;
  EXPECT_EQ(ReadBytes(this->PathOf("points.csv")), "x,y,z,Label,scale,radius,response\n");
  this->WriteStain("smooth.mha", [&](StainType * image) {
    fill(image);
    const auto smooth = itk::DiscreteGaussianImageFilter<StainType, StainType>::New();
    smooth->SetInput(image);
    smooth->SetVariance(1.0);
    smooth->Update();
    std::copy_n(smooth->GetOutput()->GetBufferPointer(), 8000, image->GetBufferPointer());
  });
  ASSERT_EQ(this->Run("smooth.mha points.csv"), 0);
  EXPECT_NE(m_Errors.find("smooth.mha: weak evidence: "), std::string::npos) << m_Errors;
}

TEST_F(NucleiDetectionApp, ImagesWithoutAScaleSpaceAreRefused)
{
  const auto refuse = [this](const std::string & message, const std::function<void(StainType *)> & change) {
    this->WriteStain("bad.mha", change);
    this->ExpectRefusal("bad.mha points.csv --picture p.png", { "NucleiDetection: bad.mha: " + message });
  };
  refuse("All pixels are 3", [](StainType * image) { image->FillBuffer(3.0f); });
  refuse("The pixel at [4, 5, 6] is nan, must be finite", [](StainType * image) {
    image->SetPixel({ { 4, 5, 6 } }, std::numeric_limits<float>::quiet_NaN());
  });
  refuse("The pixel at [4, 5, 6] is -inf, must be finite", [](StainType * image) {
    image->SetPixel({ { 4, 5, 6 } }, -std::numeric_limits<float>::infinity());
  });
  const auto flat = itk::Image<float, 2>::New();
  flat->SetRegions(itk::Size<2>{ { 5, 5 } });
  flat->Allocate(true);
  this->WriteImage(flat.GetPointer(), "flat.mha");
  this->ExpectRefusal("flat.mha points.csv", { "flat.mha: the image has 2 dimensions, an image of a stain has 3" });
  this->ExpectRefusal("none.mha points.csv", { "none.mha: no such file" });
  std::ofstream(this->PathOf("text.txt")) << "no image";
  this->ExpectRefusal("text.txt points.csv", { "text.txt: not an image" });
  this->WriteStain("whole.mha");
  std::ofstream(this->PathOf("cut.mha"), std::ios::binary) << ReadBytes(this->PathOf("whole.mha")).substr(0, 20000);
  this->ExpectRefusal("cut.mha points.csv", { "cut.mha: the file is cut off or broken" });
}

TEST_F(NucleiDetectionApp, OptionsThatAreRefused)
{
  this->WriteStain("blob.mha");
  for (const auto & [options, message] : std::vector<std::pair<std::string, std::string>>{
         { "--minimumScale 0.4 --maximumScale 4",
           "blob.mha: The minimum scale is 0.4, must be half a voxel at least: 0.5" },
         { "--minimumScale 1 --maximumScale 21",
           "blob.mha: The maximum scale is 21, must not exceed the shortest side of the image: 20" },
         { "--minimumScale 4 --maximumScale 2", "The scales are 4 to 2" },
         { "--minimumScale 4", "The scales are 4 to 0" },
         { "--minimumScale nan --maximumScale 4", "--minimumScale: nan is out of range" },
         { "--threshold nan", "--threshold: nan is out of range" },
         { "--threshold -1", "--threshold: -1 is out of range, must be in 0 .. 1e+12" },
         { "--relativeThreshold 1", "--relativeThreshold: 1 is out of range" },
         { "--maximumOverlap 1.1", "--maximumOverlap: 1.1 is out of range" },
         { "--stepsPerOctave 0", "--stepsPerOctave: 0 is out of range" },
         { "--borderMargin inf", "--borderMargin: inf is out of range" },
         { "--spacing 1 nan 1", "--spacing: nan is out of range" },
         { "--picture blobs.jpg", "'blobs.jpg', must end in .png" },
         { "--picture none/blobs.png", "'none/blobs.png': there is no folder" },
         { "--unknown", "--unknown" } })
  {
    this->ExpectRefusal("blob.mha points.csv " + options, { message });
  }
  this->ExpectRefusal("blob.mha points.txt", { "'points.txt': they are written to .csv, .fcsv, .mrk.json and .vtp" });
  this->ExpectRefusal("blob.mha none/points.csv", { "'none/points.csv': there is no folder" });
  this->ExpectRefusal("blob.mha", { "points is required" });
}

TEST_F(NucleiDetectionApp, OutputsDoNotReplaceTheImageAndComeTogether)
{
  this->WriteStain("blob.mhd");
  const std::string voxels = ReadBytes(this->PathOf("blob.raw"));
  for (const char * data : { "blob.raw", "blob.mhd" })
  {
    std::filesystem::create_symlink(data, this->PathOf("link.png"));
    this->ExpectRefusal("blob.mhd points.csv --picture link.png", { "Cannot write 'link.png': it " });
    std::filesystem::remove(this->PathOf("link.png"));
  }
  EXPECT_EQ(ReadBytes(this->PathOf("blob.raw")), voxels);
  this->MakeNuclei();
  std::ofstream(this->PathOf("points.csv")) << "old";
  // Files may have so many blocks of 512 bytes: fewer than the points, then than the picture.
  for (const auto & [blocks, file] : { std::make_pair("2", "points.csv"), std::make_pair("20", "p.png") })
  {
    this->ExpectRefusal("nuclei.mha points.csv --picture p.png",
                        { "Cannot write '" + std::string(file) + "': " },
                        "trap '' XFSZ && ulimit -f " + std::string(blocks) + " &&");
  }
  EXPECT_EQ(ReadBytes(this->PathOf("points.csv")), "old");
}
