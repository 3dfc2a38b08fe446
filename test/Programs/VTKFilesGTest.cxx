/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/VTKFiles.h"
#include "TemporaryFolder.h"
#include "TissueTessellationVTKBridge.h"

#include <gtest/gtest.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <stdexcept>

#ifdef __unix__
#  include <csignal>
#  include <sys/resource.h>
#endif

namespace
{
class VTKFilesTest : public TemporaryFolderTest
{
protected:
  const FourCubes m_Tissue;
};
} // namespace

TEST_F(VTKFilesTest, WallsReadBackAsTheyWere)
{
  const auto walls = tissue::MakeWallPolyData(m_Tissue.mesh, m_Tissue.cells);
  tissue::WriteXML(walls, PathOf("a.vtp"));
  tissue::WriteXML(walls, PathOf("b.vtp"));
  EXPECT_EQ(ReadBytes(PathOf("a.vtp")), ReadBytes(PathOf("b.vtp")));
  EXPECT_NE(ReadBytes(PathOf("a.vtp")).find("vtkZLibDataCompressor"), std::string::npos);

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(PathOf("a.vtp").c_str());
  reader->Update();
  vtkPolyData * read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfPoints(), 18);
  ASSERT_EQ(read->GetNumberOfPolys(), 40);
  EXPECT_STREQ(read->GetCellData()->GetScalars()->GetName(), "Label");
  for (const char * name : { "Label", "BoundaryLabels", "WallId", "WallArea" })
  {
    vtkDataArray * expected = walls->GetCellData()->GetArray(name);
    vtkDataArray * array = read->GetCellData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetDataType(), expected->GetDataType()) << name;
    ASSERT_EQ(array->GetNumberOfValues(), expected->GetNumberOfValues()) << name;
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      EXPECT_EQ(array->GetVariantValue(i), expected->GetVariantValue(i)) << name;
    }
  }
  EXPECT_NE(read->GetPointData()->GetArray("NumberOfCells"), nullptr);
  auto * space = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("SPACE"));
  ASSERT_NE(space, nullptr);
  EXPECT_EQ(space->GetValue(0), "LPS");
}

TEST_F(VTKFilesTest, PolyhedraReadBackAsTheyWere)
{
  const auto check = tissue::CheckCellSurfaces(m_Tissue.mesh, 5);
  tissue::WriteXML(tissue::MakeCellGrid(m_Tissue.mesh, m_Tissue.cells, check, m_Tissue.Statistics()), PathOf("a.vtu"));
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(PathOf("a.vtu").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 4);
  EXPECT_EQ(reader->GetOutput()->GetCellType(3), VTK_POLYHEDRON);
  EXPECT_EQ(reader->GetOutput()->GetCell(3)->GetNumberOfFaces(), 12);
  EXPECT_EQ(reader->GetOutput()->GetCellData()->GetArray("NumberOfVoxels")->GetComponent(3, 0), 1004.0);
}

TEST_F(VTKFilesTest, TheTableIsCommaSeparatedWithExactNumbers)
{
  FourCubes tissue;
  tissue.cells[1].center[0] = 123456.78901234567;
  const auto check = tissue::CheckCellSurfaces(tissue.mesh, 5);
  tissue::WriteCSV(tissue::MakeCellTable(tissue.mesh, tissue.cells, check, tissue.Statistics()), PathOf("a.csv"));
  std::ifstream file(PathOf("a.csv"));
  std::string   header;
  std::string   row;
  std::getline(file, header);
  std::getline(file, row);
  EXPECT_EQ(
    header,
    "Label,CenterX,CenterY,CenterZ,Volume,ImageVolume,SurfaceArea,NumberOfNeighbors,NumberOfTriangles,"
    "EulerCharacteristic,MinimumDihedralAngle,IsClosed,TouchesExterior,TouchesBorder,NumberOfPieces,NumberOfVoxels,"
    "NumberOfStrayVoxels,ExteriorArea,CutArea,Layer,Sphericity,Elongation,Flatness,MajorAxisLength,MajorAxisX,"
    "MajorAxisY,MajorAxisZ,MiddleAxisLength,MiddleAxisX,MiddleAxisY,MiddleAxisZ,MinorAxisLength,MinorAxisX,MinorAxisY,"
    "MinorAxisZ,MeanCurvature,GaussianCurvature,MaximumCurvature,MinimumCurvature");
  EXPECT_EQ(row.substr(0, 71), "10,123456.78901234567,0.5,0.5,1,0.875,6,2,12,2,90,1,1,0,1,1001,0,4,0,1,");
}

TEST_F(VTKFilesTest, TextInTheTableIsQuotedWhereItMustBe)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (const char * name : { "cell 1", "a,b", "a \"b\"", "" })
  {
    names->InsertNextValue(name);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(names);
  tissue::WriteCSV(table, PathOf("a.csv"));
  EXPECT_EQ(ReadBytes(PathOf("a.csv")), "Name\ncell 1\n\"a,b\"\n\"a \"\"b\"\"\"\n\n");
}

#ifdef __unix__
TEST_F(VTKFilesTest, AFullDiskIsAnErrorAndLeavesNothing)
{
  // A limit on the size of files stands for the full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 100;
  const auto walls = tissue::MakeWallPolyData(m_Tissue.mesh, m_Tissue.cells);
  const auto check = tissue::CheckCellSurfaces(m_Tissue.mesh, 5);
  const auto table = tissue::MakeCellTable(m_Tissue.mesh, m_Tissue.cells, check, m_Tissue.Statistics());
  setrlimit(RLIMIT_FSIZE, &small);
  std::vector<std::string> errors;
  for (const std::string name : { "a.vtp", "a.csv" })
  {
    try
    {
      tissue::OutputFiles files;
      files.Add(PathOf(name), [&](const std::string & path) {
        name == "a.vtp" ? tissue::WriteXML(walls, path) : tissue::WriteCSV(table, path);
      });
    }
    catch (const std::runtime_error & error)
    {
      errors.push_back(error.what());
    }
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(List(), "");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0], "Cannot write '" + PathOf("a.vtp") + "': File too large");
  EXPECT_EQ(errors[1], "Cannot write '" + PathOf("a.csv") + "': File too large");
}
#endif
