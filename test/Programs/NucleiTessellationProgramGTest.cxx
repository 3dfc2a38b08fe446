/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The program for points, from end to end.
#include "MembraneImage.h"
#include "TissueTessellationProgramTest.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>

namespace
{
using ImageType = itk::Image<unsigned char, 3>;

class NucleiTessellationApp : public TissueTessellationAppTest
{
protected:
  NucleiTessellationApp() { m_Program = NUCLEI_TESSELLATION_PROGRAM; }

  /** A small tissue, `tissue.mha`, and the centres of its cells, `points.csv`. */
  void
  SetUp() override
  {
    TissueTessellationAppTest::SetUp();
    m_Tissue = MakeSyntheticTestTissue<unsigned char>();
    this->WriteImage(m_Tissue.GetPointer(), "tissue.mha");
    const tissue::JunctionSet junctions = tissue_test::Extract(m_Tissue.GetPointer());
    for (std::size_t v = 1; v < junctions.cells.size(); ++v)
    {
      m_Points[junctions.cells[v].label] = junctions.cells[v].center;
    }
    std::ofstream file(this->PathOf("points.csv"));
    file << "Volume,Label,x_um,y_um,z_um\n" << std::setprecision(17);
    for (const auto & [label, p] : m_Points)
    {
      file << "0," << label << ',' << p[0] << ',' << p[1] << ',' << p[2] << '\n';
    }
  }

  ImageType::Pointer                     m_Tissue;
  std::map<tissue::Label, tissue::Point> m_Points;
};
} // namespace

TEST_F(NucleiTessellationApp, MakesSoundWallsOfPointsByBothWays)
{
  for (const char * options : { "", " --preset paper" })
  {
    const auto report = this->RunAndReport(std::string("points.csv walls.vtp --refinement 0 --box tissue.mha "
                                                       "--evaluateAgainst tissue.mha") +
                                           options);
    EXPECT_EQ(report["program"]["name"], "NucleiTessellation");
    EXPECT_EQ(report["input"]["points"], m_Points.size());
    EXPECT_EQ(report["input"]["cells"], m_Points.size());
    EXPECT_TRUE(report["mesh"]["cellsWithoutTriangles"].empty());
    EXPECT_TRUE(report["mesh"]["cellsThatAreNoClosedSphere"].empty());
    EXPECT_EQ(report["evaluation"]["missedCells"], 0);
    EXPECT_EQ(report["evaluation"]["cellsWithoutCounterpart"], 0);
    EXPECT_GT(report["evaluation"]["optimized"]["adjacency2"], 0.7);
    const bool isPaper = *options != '\0';
    EXPECT_EQ(report["options"]["fixed"]["complex"], isPaper ? "centers" : "image");
    EXPECT_EQ(report["evaluation"].contains("cleaned"), isPaper);
    EXPECT_EQ(report["mesh"]["meanVolumeError"].is_null(), isPaper);
  }
}

TEST_F(NucleiTessellationApp, JudgesCellsByTheirPlacesOrByTheirLabels)
{
  const tissue::Label last = m_Points.rbegin()->first;
  std::ofstream       file(this->PathOf("turned.csv"));
  file << "label,x,y,z\n" << std::setprecision(17);
  for (const auto & [label, p] : m_Points)
  {
    const tissue::Label other = label == last ? m_Points.begin()->first : m_Points.upper_bound(label)->first;
    file << other << ',' << p[0] << ',' << p[1] << ',' << p[2] << '\n';
  }
  file.close();
  const std::string rest = " walls.vtp --preset paper --evaluateAgainst tissue.mha";
  const auto        adjacency2 = [&](const std::string & points, const std::string & options) {
    return this->RunAndReport(points + rest + options)["evaluation"]["delaunay"]["adjacency2"].get<double>();
  };
  EXPECT_EQ(adjacency2("points.csv", " --evaluateByLabel"), adjacency2("points.csv", ""));
  EXPECT_GT(adjacency2("turned.csv", ""), 0.6);
  EXPECT_LT(adjacency2("turned.csv", " --evaluateByLabel"), 0.6);
  this->ExpectRefusal("points.csv walls.vtp --evaluateByLabel", { "--evaluateAgainst" });
}

TEST_F(NucleiTessellationApp, ReportsNothingOfAnImageWhereThereIsNone)
{
  const auto  alone = this->RunAndReport("points.csv walls.vtp --preset paper");
  const auto  input = alone["input"];
  std::size_t number = 0;
  for (const char * ofImage :
       { "pixelType", "size", "spacing", "voids", "walls", "tripleLines", "junctions", "blocksOfMoreThanFourCells" })
  {
    number += input.contains(ofImage) && input[ofImage].is_null() ? 1 : 0;
  }
  EXPECT_EQ(number, 8u) << input;
  for (const char * stage : { "delaunay", "cleaned", "optimized" })
  {
    EXPECT_TRUE(alone["stages"][stage]["adjacency2"].is_null());
    EXPECT_TRUE(alone["stages"][stage]["adjacency4"].is_null());
    EXPECT_GT(alone["stages"][stage]["eccentricity"], 0.0);
  }
  EXPECT_EQ(m_Output.find("points.csv: " + std::to_string(m_Points.size()) + " points in um; " +
                          std::to_string(m_Points.size()) + " cells, exterior label 0\n"),
            0u)
    << m_Output;
  for (const char * ofImage : { "voxels", "adjacency", "image" })
  {
    EXPECT_EQ(m_Output.find(ofImage), std::string::npos) << m_Output;
  }
  EXPECT_TRUE(alone["warnings"].empty());
  const auto unused =
    this->RunAndReport("points.csv walls.vtp --preset paper --box tissue.mha --junctions j.csv")["warnings"];
  ASSERT_EQ(unused.size(), 2u);
  EXPECT_EQ(unused[0], "--box is not used: --preset paper makes walls of the points alone");
  EXPECT_EQ(unused[1], "--junctions: points alone have none in an image, the table is empty");
  const auto fitted = this->RunAndReport("points.csv walls.vtp --refinement 0");
  EXPECT_GT(fitted["stages"]["optimized"]["adjacency4"], 0.5);
  EXPECT_GT(fitted["input"]["walls"], 0);
  EXPECT_NE(m_Output.find(" voxels of "), std::string::npos) << m_Output;
  EXPECT_NE(m_Output.find("adjacency4"), std::string::npos) << m_Output;
}

TEST_F(NucleiTessellationApp, LabelsAreThoseOfTheFileOrOfTheImage)
{
  ASSERT_EQ(this->Run("points.csv a.vtp --refinement 0 --box tissue.mha"), 0) << m_Errors;
  ASSERT_EQ(this->Run("--centersOf tissue.mha b.vtp --refinement 0"), 0) << m_Errors;
  EXPECT_EQ(ReadBytes(this->PathOf("a.vtp")), ReadBytes(this->PathOf("b.vtp")));
}

TEST_F(NucleiTessellationApp, TheSamePointsInAnyFormatGiveTheSameWalls)
{
  std::ofstream             plain(this->PathOf("plain.csv"));
  std::ofstream             markups(this->PathOf("markups.fcsv"));
  const vtkNew<vtkPoints>   points;
  const vtkNew<vtkPolyData> data;
  points->SetDataTypeToDouble();
  plain << std::setprecision(17);
  markups << std::setprecision(17) << "# Markups fiducial file version = 4.10\n# CoordinateSystem = 0\n"
          << "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
  for (const auto & [label, p] : m_Points)
  {
    plain << p[0] << ';' << p[1] << ';' << p[2] << '\n';
    markups << "node," << -p[0] << ',' << -p[1] << ',' << p[2] << ",0,0,0,1,1,1,0,F-" << label << ",,\n";
    points->InsertNextPoint(p.data());
  }
  plain.close();
  markups.close();
  data->SetPoints(points);
  const vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(this->PathOf("points.vtp").c_str());
  ASSERT_EQ(writer->Write(), 1);
  std::set<std::string> meshes;
  for (const char * file : { "plain.csv", "markups.fcsv", "points.vtp" })
  {
    ASSERT_EQ(this->Run(std::string(file) + " walls.vtp --preset paper"), 0) << m_Errors;
    meshes.insert(ReadBytes(this->PathOf("walls.vtp")));
  }
  EXPECT_EQ(meshes.size(), 1u);
}

TEST_F(NucleiTessellationApp, NucleiOfAnImageAreThePoints)
{
  // The box of the tissue in voxels of half the size, and nuclei that are small beside the cells.
  const auto stain = itk::Image<float, 3>::New();
  const auto coarse = m_Tissue->GetLargestPossibleRegion().GetSize();
  stain->SetRegions(itk::Size<3>{ { 2 * coarse[0], 2 * coarse[1], 2 * coarse[2] } });
  stain->SetOrigin(m_Tissue->GetOrigin());
  stain->SetDirection(m_Tissue->GetDirection());
  stain->SetSpacing(m_Tissue->GetSpacing() * 0.5);
  stain->Allocate();
  const auto   spacing = m_Tissue->GetSpacing();
  const double sigma = 0.8 * std::max({ spacing[0], spacing[1], spacing[2] });
  for (itk::ImageRegionIteratorWithIndex<itk::Image<float, 3>> it(stain, stain->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    const auto position = stain->TransformIndexToPhysicalPoint<double>(it.GetIndex());
    double     value = 0.0;
    for (const auto & [label, p] : m_Points)
    {
      value += 1000.0 *
               std::exp(-0.5 * position.SquaredEuclideanDistanceTo(itk::Point<double, 3>(p.data())) / (sigma * sigma));
    }
    it.Set(static_cast<float>(value));
  }
  this->WriteImage(stain.GetPointer(), "nuclei.mha");
  std::ostringstream scales;
  scales << " --minimumScale " << 0.7 * sigma << " --maximumScale " << 1.8 * sigma;
  const auto report =
    this->RunAndReport("nuclei.mha walls.vtp --refinement 0 --evaluateAgainst tissue.mha" + scales.str());
  EXPECT_EQ(report["input"]["points"], m_Points.size());
  EXPECT_EQ(report["evaluation"]["missedCells"], 0);
  EXPECT_EQ(report["options"]["points"], "nuclei");
  EXPECT_GT(report["evaluation"]["optimized"]["adjacency2"], 0.7);
  this->ExpectRefusal("nuclei.mha walls.vtp --threshold 1e6" + scales.str(),
                      { "nuclei.mha: 0 nuclei of scales from ", "have a response of 1e+06 or more" });
}

TEST_F(NucleiTessellationApp, MembranesBesideThePointsAndAloneAgreeWithTheTissue)
{
  this->WriteImage(tissue_test::MakeMembraneImage<unsigned char>(m_Tissue.GetPointer()).GetPointer(), "membrane.mha");
  const std::string rest = " walls.vtp --refinement 0 --evaluateAgainst tissue.mha";
  const auto        with = this->RunAndReport("points.csv --membrane membrane.mha" + rest);
  EXPECT_GT(with["evaluation"]["optimized"]["adjacency4"], 0.4);
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  const auto alone = this->RunAndReport("--membrane membrane.mha" + rest);
  EXPECT_GT(alone["evaluation"]["optimized"]["adjacency4"], 0.3);
  EXPECT_EQ(alone["input"]["exteriorLabel"], 0);
  EXPECT_GT(alone["input"]["membraneMinima"]["noise"], 0.0);
  EXPECT_GE(alone["input"]["membraneMinima"]["leastDepth"], 0.015);
  EXPECT_NE(m_Output.find("Membranes: noise of deviation "), std::string::npos) << m_Output;
}

TEST_F(NucleiTessellationApp, DarkMembranesAreTheBrightOnesOfTheInverse)
{
  const auto membranes = tissue_test::MakeMembraneImage<unsigned char>(m_Tissue.GetPointer());
  this->WriteImage(membranes.GetPointer(), "bright.mha");
  const auto number = membranes->GetBufferedRegion().GetNumberOfPixels();
  std::transform(membranes->GetBufferPointer(),
                 membranes->GetBufferPointer() + number,
                 membranes->GetBufferPointer(),
                 [](unsigned char pixel) { return static_cast<unsigned char>(255 - pixel); });
  this->WriteImage(membranes.GetPointer(), "dark.mha");
  const auto walls = [this](const std::string & arguments) {
    EXPECT_EQ(this->Run(arguments + " walls.vtp --refinement 0"), 0) << m_Errors;
    return ReadBytes(this->PathOf("walls.vtp"));
  };
  EXPECT_EQ(walls("points.csv --membrane bright.mha"), walls("points.csv --membrane dark.mha --darkMembranes"));
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  const std::string bright = walls("--membrane bright.mha");
  EXPECT_EQ(bright, walls("--membrane dark.mha --dark"));
  EXPECT_NE(bright, walls("--membrane dark.mha"));
}

TEST_F(NucleiTessellationApp, RepeatedPointsAreLeftOutAndSaid)
{
  const tissue::Point & p = m_Points.begin()->second;
  std::ofstream         file(this->PathOf("points.csv"), std::ios::app);
  file << std::setprecision(17);
  for (const int label : { 2000, 2001 })
  {
    file << "0," << label << ',' << p[0] << ',' << p[1] << ',' << p[2] << '\n';
  }
  file.close();
  for (const char * preset : { " --refinement 0", " --preset paper" })
  {
    const auto report = this->RunAndReport(std::string("points.csv walls.vtp") + preset);
    EXPECT_EQ(report["input"]["points"], m_Points.size());
    EXPECT_EQ(report["input"]["cells"], m_Points.size());
    ASSERT_EQ(report["warnings"].size(), 1u);
    EXPECT_NE(report["warnings"][0].get<std::string>().find(
                "2 of 42 points repeat another and are left out (line 42 that of line 2, ...)"),
              std::string::npos)
      << report["warnings"];
    EXPECT_NE(m_Errors.find("NucleiTessellation: warning: 2 of "), std::string::npos) << m_Errors;
  }
}

TEST_F(NucleiTessellationApp, FewPointsAndCloseOnesAreCells)
{
  const std::string four = "0,0,0\n10,0,0\n0,10,0\n0,0,10\n";
  for (const auto & [points, number] : std::vector<std::pair<std::string, int>>{
         { four, 4 }, { four + "8,8,8\n", 5 }, { four + "8,8,8\n8,8,8.0000000001\n", 6 } })
  {
    std::ofstream(this->PathOf("few.csv")) << points;
    for (const char * preset : { " --refinement 0", " --preset paper" })
    {
      const auto report = this->RunAndReport(std::string("few.csv walls.vtp") + preset);
      EXPECT_EQ(report["input"]["cells"], number) << points << preset;
      EXPECT_TRUE(report["mesh"]["cellsWithoutTriangles"].empty()) << points << preset;
      EXPECT_TRUE(report["mesh"]["cellsThatAreNoClosedSphere"].empty()) << points << preset;
    }
  }
}

TEST_F(NucleiTessellationApp, PointsFarFromTheOriginKeepTheirDigits)
{
  // Single precision would know them to a cell's diameter.
  std::ofstream far(this->PathOf("far.csv"));
  far << "Label,x,y,z\n" << std::setprecision(17);
  for (const auto & [label, p] : m_Points)
  {
    far << label << ',' << p[0] + 1e8 << ',' << p[1] << ',' << p[2] - 1e8 << '\n';
  }
  far.close();
  const auto near = this->RunAndReport("points.csv walls.vtp --refinement 0");
  const auto moved = this->RunAndReport("far.csv walls.vtp --refinement 0");
  EXPECT_NEAR(moved["stages"]["optimized"]["adjacency4"], near["stages"]["optimized"]["adjacency4"], 0.05);
  EXPECT_NEAR(moved["stages"]["nerve"]["eccentricity"], near["stages"]["nerve"]["eccentricity"], 1e-4);
  EXPECT_TRUE(moved["mesh"]["cellsThatAreNoClosedSphere"].empty());
}

TEST_F(NucleiTessellationApp, PointsInOnePlaneAreNoSolidTissue)
{
  for (const char * points : { "x,y,z\n0,0,0\n5,0,0\n0,5,0\n5,5,0\n2,1,0\n", "0,0,0\n1,1,1\n2,2,2\n3,3,3\n" })
  {
    std::ofstream(this->PathOf("flat.csv")) << points;
    this->ExpectRefusal("flat.csv walls.vtp --preset paper", { "flat.csv: ", "coplanar" });
    this->ExpectRefusal("flat.csv walls.vtp --layer off", { "flat.csv: ", "coplanar" });
  }
  this->ExpectRefusal("flat.csv walls.vtp --layer maybe", { "--layer" });
}

TEST_F(NucleiTessellationApp, PointFilesThatAreRefused)
{
  const auto refuse =
    [this](const std::string & content, const std::vector<std::string> & parts, const std::string & name = "bad.csv") {
      std::ofstream(this->PathOf(name)) << content;
      for (const char * preset : { "", " --preset paper" })
      {
        this->ExpectRefusal(name + " walls.vtp" + preset, parts);
      }
    };
  const std::string four = "x,y,z\n0,0,0\n5,0,1\n0,5,0\n0,1,5\n";
  this->ExpectRefusal("none.csv walls.vtp", { "none.csv: no such file" });
  refuse(four, { "bad.xyzw: neither an image in a format that ITK reads nor a file of points" }, "bad.xyzw");
  refuse("", { "bad.csv: There are 0 points, at least 4 are needed" });
  refuse("x,y,z\n1,2,3\n2,3,4\n4,3,2\n", { "bad.csv: There are 3 points, at least 4 are needed" });
  refuse("x,y\n1,2\n", { "bad.csv: line 1: there is no column z" });
  refuse("a,b,c\n1,2,3\n", { "bad.csv: line 1: there is no column x among 'a', 'b', 'c'" });
  refuse(four + "1,2\n", { "bad.csv: line 6: there are 2 values, but 3 names, in line 1" });
  refuse(four + "1,two,3\n", { "bad.csv: line 6: 'two' in column 2 ('y') is no number" });
  refuse(four + "1,2,\n", { "bad.csv: line 6" });
  refuse(four + "1,nan,3\n", { "bad.csv: line 6: 'nan' in column 2 ('y') must be finite" });
  refuse(four + "1,2,inf\n", { "bad.csv: line 6: 'inf' in column 3 ('z') must be finite" });
  refuse("x,y,z\n0,0,0\n5,0,0\n0,0,0\n5,0,0\n2,1,0\n", { "bad.csv: There are 3 points" });
  refuse("1,1,1\n1,1,1\n1,1,1\n1,1,1\n", { "bad.csv: There are 1 points, at least 4 are needed" });
  refuse(four + "1e300,2,3\n",
         { "bad.csv: The point of label 5 has the coordinate 1e+300, must be finite and at most" });
  refuse("0,0,0\n1e-300,0,0\n0,1e-300,0\n0,0,1e-300\n", { "bad.csv: The points extend over 1e-300, must be 1e-30" });
  refuse("Label,x,y,z\n1,0,0,0\n1,5,0,0\n", { "bad.csv: line 3 has the label 1 of line 2" });
  refuse("Label,x,y,z\n1.5,0,0,0\n", { "bad.csv: line 2: '1.5' in column 1 ('Label') is no whole number from 0 on" });
  refuse("# CoordinateSystem = XYZ\n", { "bad.fcsv: line 1: the coordinate system 'XYZ'" }, "bad.fcsv");
  refuse("not XML", { "bad.vtp: ", "no VTK file of polygonal data" }, "bad.vtp");
}

TEST_F(NucleiTessellationApp, OtherFilesAndOptionsThatAreRefused)
{
  this->ExpectRefusal("", { "points is required" });
  this->ExpectRefusal("points.csv", { "walls is required" });
  this->ExpectRefusal("points.csv walls.vtp --membrane none.mha", { "NucleiTessellation: none.mha: no such file" });
  this->ExpectRefusal("points.csv walls.vtp --box none.mha", { "NucleiTessellation: none.mha: no such file" });
  this->ExpectRefusal("points.csv walls.vtp --evaluateAgainst none.mha", { "none.mha: no such file" });
  this->ExpectRefusal("points.csv walls.vtp --voxelsPerCell 1", { "--voxelsPerCell: 1 is out of range" });
  this->ExpectRefusal("points.csv walls.vtp --preset paper --delaunayWeight=-1",
                      { "--delaunayWeight: -1 is out of range, must be in 0 .. 1e+06" });
  this->ExpectRefusal("points.csv walls.vtp --preset paper --unitLength=-2",
                      { "unitLength is -2, must be in 1e-12 .. 1e+12" });
  this->ExpectRefusal("points.csv walls.vtp --membraneSigma -1", { "--membraneSigma: -1 is out of range" });
  const auto flat = ImageType::New();
  flat->SetRegions(m_Tissue->GetLargestPossibleRegion());
  flat->CopyInformation(m_Tissue);
  flat->Allocate(true);
  this->WriteImage(flat.GetPointer(), "flat.mha");
  this->ExpectRefusal("points.csv walls.vtp --membrane flat.mha", { "flat.mha: All pixels of the image are 0" });
  flat->SetOrigin(itk::Point<double, 3>(std::array<double, 3>{ { 1000.0, 0.0, 0.0 } }.data()));
  flat->SetPixel({ { 3, 3, 3 } }, 1);
  this->WriteImage(flat.GetPointer(), "aside.mha");
  this->ExpectRefusal("points.csv walls.vtp --box aside.mha", { "points.csv: ", "box" });
  std::filesystem::copy_file(this->PathOf("tissue.mha"), this->PathOf("judge.vtp"));
  this->ExpectRefusal("points.csv judge.vtp --evaluateAgainst judge.vtp", { "'judge.vtp': it is the input" });
}

TEST_F(NucleiTessellationApp, TakesCentresOfLabelsThatTouchNobody)
{
  // A marker of 3 x 3 x 1 voxels at each centre.
  const auto nuclei = ImageType::New();
  nuclei->CopyInformation(m_Tissue);
  nuclei->SetRegions(m_Tissue->GetLargestPossibleRegion());
  nuclei->Allocate(true);
  for (const auto & [label, p] : m_Points)
  {
    const auto center = nuclei->TransformPhysicalPointToIndex(itk::Point<double, 3>(p.data()));
    for (int i = 0; i < 9; ++i)
    {
      nuclei->SetPixel({ { center[0] - 1 + i % 3, center[1] - 1 + i / 3, center[2] } },
                       static_cast<unsigned char>(label));
    }
  }
  this->WriteImage(nuclei.GetPointer(), "nuclei.mha");
  const auto report = this->RunAndReport("--centersOf nuclei.mha walls.vtp --refinement 0");
  EXPECT_EQ(report["input"]["points"], m_Points.size());
  EXPECT_EQ(report["input"]["cells"], m_Points.size());
}
