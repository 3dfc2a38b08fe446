/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueMeshEvaluationProgramTest.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>
#include <fstream>

TEST_F(TissueMeshEvaluationApp, AgreesWithTheProgramThatMadeTheMesh)
{
  this->MakeMesh();
  const auto made = this->ReadReport();
  ASSERT_EQ(this->Evaluate("walls.vtp tissue.mha --report report.json"), 0) << m_Errors;
  const auto report = this->ReadReport();
  EXPECT_EQ(report["cells"], 40);
  EXPECT_EQ(report["spheres"], 40);
  EXPECT_EQ(report["cellsOfSpheres"], 40);
  EXPECT_EQ(report["triangles"], made["mesh"]["triangles"]);
  EXPECT_DOUBLE_EQ(report["adjacency2"], made["stages"]["optimized"]["adjacency2"]);
  EXPECT_DOUBLE_EQ(report["adjacency4"], made["stages"]["optimized"]["adjacency4"]);
  EXPECT_GT(report["adjacency4OfNeighbors"], 0.5);
  EXPECT_EQ(report["falsePairs"].get<int>() + report["missingPairs"].get<int>() == 0, report["adjacency2"] == 1.0);
  EXPECT_LE(report["separateWalls"]["keptPairs"], report["separateWalls"]["pairs"]);
  EXPECT_EQ(report["exterior"]["image"]["genus"], 0);
  EXPECT_EQ(report["exterior"]["mesh"], report["exterior"]["image"]);
  EXPECT_EQ(report["cornersOfMoreThanFourCells"], 0);
  EXPECT_EQ(report["crossingPairs"], 0);
  EXPECT_GT(report["meanDice"], 0.85);
  ASSERT_EQ(report["byCell"].size(), 40u);
  const auto & cell = report["byCell"][7];
  EXPECT_EQ(cell["label"], 8);
  EXPECT_EQ(cell["pieces"], 1);
  // Voxels of 0.5 x 0.5 x 1.
  EXPECT_NEAR(cell["wallDistanceInVoxels"].get<double>(), cell["wallDistance"].get<double>() / std::cbrt(0.25), 1e-9);
  EXPECT_NE(m_Output.find("Adjacency2, adjacency4"), std::string::npos) << m_Output;
}

TEST_F(TissueMeshEvaluationApp, HoleAndTurnedTriangleOpenTheirCells)
{
  const auto              mesh = this->MakeMesh();
  const vtkNew<vtkIdList> triangle;
  mesh->BuildCells();
  mesh->GetCellPoints(0, triangle);
  const vtkIdType turned[3] = { triangle->GetId(0), triangle->GetId(2), triangle->GetId(1) };
  mesh->ReplaceCell(0, 3, turned);
  this->WriteMesh(mesh, "turned.vtp");
  ASSERT_EQ(this->Evaluate("turned.vtp tissue.mha --report report.json"), 0) << m_Errors;
  EXPECT_LT(this->ReadReport()["closedCells"], 40);
  EXPECT_LT(this->ReadReport()["cellsOfSpheres"], 40);
}

TEST_F(TissueMeshEvaluationApp, RefusesMeshesThatItCannotJudge)
{
  const auto mesh = this->MakeMesh();
  this->ExpectRefusal("absent.vtp tissue.mha", { "absent.vtp", "no such file" });
  this->ExpectRefusal("tissue.mha tissue.mha", { "tissue.mha", "no mesh in a format that is read", ".vtu" });
  this->ExpectRefusal("walls.vtp absent.mha", { "absent.mha" });
  this->ExpectRefusal("walls.vtp tissue.mha --labelArray Cells", { "walls.vtp", "Cells" });
  this->ExpectRefusal("walls.vtp tissue.mha --labelArray Label", { "walls.vtp", "share no polygon", "array Label" });
  this->ExpectRefusal("walls.vtp tissue.mha --labelArray Label,Wall", { "walls.vtp", "array Wall", "WallId of 1" });
  this->ExpectRefusal("walls.vtp tissue.mha --labelArray Label,BoundaryLabels", { "2 components, must have 1" });
  this->ExpectRefusal("walls.vtp tissue.mha --report folder/absent.json", { "folder/absent.json" });
  this->ExpectRefusal("walls.vtp tissue.mha --refinement 2", { "--refinement" });

  const vtkNew<vtkPolyData> foreign;
  foreign->DeepCopy(mesh);
  foreign->GetCellData()->GetArray("BoundaryLabels")->SetComponent(3, 0, 777.0);
  this->WriteMesh(foreign, "foreign.vtp");
  this->ExpectRefusal("foreign.vtp tissue.mha", { "foreign.vtp", "777" });

  const vtkNew<vtkPolyData> fractional;
  fractional->DeepCopy(mesh);
  const auto *                 labels = fractional->GetCellData()->GetArray("BoundaryLabels");
  const vtkNew<vtkDoubleArray> numbers;
  numbers->DeepCopy(const_cast<vtkDataArray *>(labels));
  numbers->SetName("BoundaryLabels");
  fractional->GetCellData()->AddArray(numbers);
  for (const double wrong : { 2.5, std::nan(""), 1e300 })
  {
    numbers->SetComponent(3, 1, wrong);
    this->WriteMesh(fractional, "fractional.vtp");
    this->ExpectRefusal("fractional.vtp tissue.mha", { "fractional.vtp", "polygon 3", "whole numbers" });
  }
  numbers->SetComponent(3, 1, -2.0);
  this->WriteMesh(fractional, "fractional.vtp");
  this->ExpectRefusal("fractional.vtp tissue.mha", { "fractional.vtp", "triangle 3 has label -2", "has not" });

  const vtkNew<vtkPolyData> infinite;
  infinite->DeepCopy(mesh);
  infinite->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  this->WriteMesh(infinite, "infinite.vtp");
  this->ExpectRefusal("infinite.vtp tissue.mha", { "infinite.vtp", "point 5" });

  const vtkNew<vtkPolyData> empty;
  this->WriteMesh(empty, "empty.vtp");
  this->ExpectRefusal("empty.vtp tissue.mha", { "empty.vtp", "no polygon" });
}

TEST_F(TissueMeshEvaluationApp, RefusesAReportThatWouldReplaceAnInput)
{
  this->MakeMesh();
  std::filesystem::create_symlink("tissue.mha", this->PathOf("link.json"));
  const std::string mesh = ReadBytes(this->PathOf("walls.vtp"));
  const std::string image = ReadBytes(this->PathOf("tissue.mha"));
  this->ExpectRefusal("walls.vtp tissue.mha --report walls.vtp", { "'walls.vtp': it is the input" });
  this->ExpectRefusal("walls.vtp tissue.mha --report ./tissue.mha", { "tissue.mha': it is the input" });
  this->ExpectRefusal("walls.vtp tissue.mha --report link.json", { "'link.json': it is the input" });
  EXPECT_EQ(ReadBytes(this->PathOf("walls.vtp")), mesh);
  EXPECT_EQ(ReadBytes(this->PathOf("tissue.mha")), image);
}

TEST_F(TissueMeshEvaluationApp, RefusesLabelsForFewerTriangles)
{
  // Two triangles, and the labels of one.
  std::ofstream(this->PathOf("short.vtk")) << "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\n"
                                              "POINTS 4 double\n0 0 0 1 0 0 0 1 0 1 1 0\n"
                                              "POLYGONS 2 8\n3 0 1 2\n3 1 3 2\n"
                                              "CELL_DATA 2\nFIELD arrays 1\nBoundaryLabels 2 1 int\n1 0\n";
  this->ExpectRefusal("short.vtk tissue.mha", { "short.vtk", "BoundaryLabels", "1 of the 2 polygons" });
}

TEST_F(TissueMeshEvaluationApp, NoClosedCellIsNoVolumeError)
{
  // One triangle of a cell.
  std::ofstream(this->PathOf("open.vtk")) << "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET POLYDATA\n"
                                             "POINTS 3 double\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n"
                                             "CELL_DATA 1\nFIELD arrays 1\nBoundaryLabels 2 1 int\n1 0\n";
  ASSERT_EQ(this->Evaluate("open.vtk tissue.mha --report report.json"), 0) << m_Errors;
  const auto report = this->ReadReport();
  EXPECT_EQ(report["closedCells"], 0);
  for (const char * const figure : { "meanVolumeError", "volumeErrorPercentile95", "meanConvexity" })
  {
    EXPECT_TRUE(report.at(figure).is_null()) << figure;
  }
  EXPECT_TRUE(report["byCell"][1]["wallDistance"].is_null());
  EXPECT_TRUE(report["byCell"][1]["wallDistanceInVoxels"].is_null());
  EXPECT_NE(m_Output.find("none, none; 0 of the cells"), std::string::npos) << m_Output;
}

TEST_F(TissueMeshEvaluationApp, JoinsTheTrianglesOfASoup)
{
  const auto                 mesh = this->MakeMesh();
  const vtkNew<vtkPolyData>  soup;
  const vtkNew<vtkPoints>    points;
  const vtkNew<vtkCellArray> triangles;
  const vtkNew<vtkIdList>    triangle;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  mesh->BuildCells();
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    mesh->GetCellPoints(t, triangle);
    triangles->InsertNextCell(3);
    for (int i = 0; i < 3; ++i)
    {
      triangles->InsertCellPoint(points->InsertNextPoint(mesh->GetPoint(triangle->GetId(i))));
    }
  }
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  soup->GetCellData()->AddArray(mesh->GetCellData()->GetArray("BoundaryLabels"));
  this->WriteMesh(soup, "soup.vtp");
  ASSERT_EQ(this->Evaluate("soup.vtp tissue.mha --report soup.json"), 0) << m_Errors;
  ASSERT_EQ(this->Evaluate("walls.vtp tissue.mha --report report.json"), 0) << m_Errors;
  auto       ofSoup = nlohmann::json::parse(ReadBytes(this->PathOf("soup.json")));
  const auto ofMesh = this->ReadReport();
  EXPECT_EQ(ofSoup["spheres"], 40);
  EXPECT_EQ(ofSoup["crossingPairs"], 0);
  EXPECT_EQ(ofSoup["corners"], ofMesh["corners"]);
  EXPECT_EQ(ofSoup["adjacency4"], ofMesh["adjacency4"]);
}

TEST_F(TissueMeshEvaluationApp, ReportIsTheSameForAnyNumberOfThreads)
{
  this->MakeMesh();
  for (const char * const threads : { "1", "2" })
  {
    ASSERT_EQ(this->Evaluate(std::string("walls.vtp tissue.mha --quiet --threads ") + threads + " --report threads" +
                             threads + ".json"),
              0)
      << m_Errors;
  }
  const std::string one = ReadBytes(this->PathOf("threads1.json"));
  EXPECT_GT(one.size(), 1000u);
  EXPECT_EQ(one, ReadBytes(this->PathOf("threads2.json")));
}

TEST_F(TissueMeshEvaluationApp, RefusesVoxelSizesThatAreNone)
{
  this->MakeMesh();
  for (const char * size : { "nan", "0", "-1" })
  {
    this->ExpectRefusal(std::string("walls.vtp tissue.mha --spacing 1 1 ") + size,
                        { std::string("--spacing: ") + size + " is out of range, must be in 1e-12 .. 1e+12" });
  }
}
