/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationProgramTest.h"

#include <nlohmann/json.hpp>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <fstream>
#include <map>

namespace
{
using Json = nlohmann::json;

class TissueTessellationApp : public TissueTessellationAppTest
{
protected:
  template <typename TReader>
  auto
  ReadVTK(const std::string & name, vtkNew<TReader> & reader) const
  {
    reader->SetFileName(this->PathOf(name).c_str());
    reader->Update();
    return reader->GetOutput();
  }
};

const std::string AllOutputs = " walls.vtp --complex complex.vtu --cells cells.vtu --statistics cells.csv "
                               "--walls walls.csv --graph graph.graphml --page page.html --report report.json ";
} // namespace

TEST_F(TissueTessellationApp, WritesAllThatIsAskedFor)
{
  this->WriteTissue<unsigned short>("tissue.mha");
  ASSERT_EQ(this->Run("tissue.mha" + AllOutputs), 0) << m_Errors;
  EXPECT_EQ(this->List(),
            "cells.csv cells.vtu complex.vtu graph.graphml page.html report.json tissue.mha walls.csv walls.vtp ");
  EXPECT_EQ(m_Errors, "");
  for (const char * said : { "40 cells", "0.5 x 0.5 x 1", "optimized", "walls.vtp (cell walls)", "report.json" })
  {
    EXPECT_NE(m_Output.find(said), std::string::npos) << said << " in\n" << m_Output;
  }

  const Json                   report = this->ReadReport();
  vtkNew<vtkXMLPolyDataReader> wallReader;
  vtkPolyData * const          walls = this->ReadVTK("walls.vtp", wallReader);
  EXPECT_EQ(walls->GetNumberOfCells(), report["mesh"]["triangles"].get<long>());
  EXPECT_EQ(walls->GetNumberOfPoints(), report["mesh"]["points"].get<long>());
  vtkDataArray * const boundaryLabels = walls->GetCellData()->GetArray("BoundaryLabels");
  ASSERT_NE(boundaryLabels, nullptr);
  std::set<double> labels;
  for (vtkIdType t = 0; t < walls->GetNumberOfCells(); ++t)
  {
    labels.insert(boundaryLabels->GetComponent(t, 0));
    labels.insert(boundaryLabels->GetComponent(t, 1));
  }
  EXPECT_EQ(labels.size(), 41u) << "every cell and the exterior";

  vtkNew<vtkXMLUnstructuredGridReader> cellReader;
  EXPECT_EQ(this->ReadVTK("cells.vtu", cellReader)->GetNumberOfCells(), 40);
  vtkNew<vtkXMLUnstructuredGridReader> complexReader;
  EXPECT_EQ(this->ReadVTK("complex.vtu", complexReader)->GetNumberOfCells(),
            report["stages"]["optimized"]["tetrahedra"].get<long>());
  const std::string table = ReadBytes(this->PathOf("cells.csv"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 41);

  const std::string page = ReadBytes(this->PathOf("page.html"));
  const std::string element = "id=\"tissue-data\">";
  const std::size_t at = page.find(element) + element.size();
  const Json        data = Json::parse(page.substr(at, page.find("</script>", at) - at));
  EXPECT_EQ(data["report"], report);
  const std::string head = table.substr(0, table.find('\n'));
  EXPECT_EQ(data["columns"].size(), static_cast<std::size_t>(std::count(head.begin(), head.end(), ',')) + 1);
  EXPECT_EQ(data["columns"][0]["values"].size(), 40u);
}

TEST_F(TissueTessellationApp, ReportsEveryStageAndSoundCells)
{
  this->WriteTissue<unsigned short>("tissue.mha");
  ASSERT_EQ(this->Run("tissue.mha walls.vtp --report report.json"), 0) << m_Errors;
  const Json report = this->ReadReport();
  for (const char * stage : { "nerve", "optimized" })
  {
    const Json & columns = report["stages"][stage];
    for (const char * column : { "adjacency2", "adjacency4" })
    {
      EXPECT_GT(columns[column].get<double>(), 0.0) << stage << column;
      EXPECT_LE(columns[column].get<double>(), 1.0) << stage << column;
    }
    for (const char * column :
         { "neighborhoodError", "eccentricity", "minimalDihedralAngle", "maximalDihedralAngle", "tetrahedra" })
    {
      EXPECT_TRUE(columns[column].is_number()) << stage << column;
    }
  }
  EXPECT_GE(report["stages"]["optimized"]["adjacency2"], report["stages"]["nerve"]["adjacency2"]);
  EXPECT_EQ(report["mesh"]["pointsWithMoreThanFourCells"], 0);
  EXPECT_EQ(report["mesh"]["cellsWithoutTriangles"], Json::array());
  EXPECT_EQ(report["mesh"]["cellsThatAreNoClosedSphere"], Json::array());
  for (const char * phase : { "read", "extractJunctions", "nerve", "optimized", "dual" })
  {
    EXPECT_GE(report["seconds"][phase].get<double>(), 0.0) << phase;
  }
}

TEST_F(TissueTessellationApp, GivesTheSameBytesForAnyNumberOfThreads)
{
  this->WriteTissue<unsigned short>("tissue.mha");
  std::map<std::string, std::string> first;
  for (const char * threads : { "1", "2", "2" })
  {
    ASSERT_EQ(this->Run("tissue.mha" + AllOutputs + "--threads " + threads), 0) << m_Errors;
    Json report = this->ReadReport();
    ASSERT_EQ(report.erase("seconds"), 1u);
    std::ofstream(this->PathOf("report.json")) << report;
    for (const char * name :
         { "walls.vtp", "complex.vtu", "cells.vtu", "cells.csv", "walls.csv", "graph.graphml", "report.json" })
    {
      const std::string bytes = ReadBytes(this->PathOf(name));
      EXPECT_TRUE(first.emplace(name, bytes).first->second == bytes) << name << ", threads " << threads;
    }
  }
}

TEST_F(TissueTessellationApp, ReadsAllFormatsAndIntegerTypesAlike)
{
  this->WriteTissue<unsigned short>("uint16.mha");
  this->WriteTissue<unsigned short>("compressed.mha", true);
  this->WriteTissue<unsigned short>("uint16.nrrd");
  this->WriteTissue<unsigned short>("compressed.nrrd", true);
  this->WriteTissue<short>("int16.nii");
  this->WriteTissue<int>("int32.nii.gz", true);
  this->WriteTissue<unsigned char>("uint8.vtk");
  this->WriteTissue<unsigned char>("lost.tif");
  this->WriteTissue<unsigned short>("compressed.tif", true);
  this->WriteTissue<signed char>("int8.mha");
  this->WriteTissue<unsigned int>("uint32.mha");
  this->WriteTissue<long long>("int64.mha");
  this->WriteTissue<unsigned long long>("uint64.mha");
  const std::string inputs = this->List();
  ASSERT_EQ(this->Run("uint16.mha reference.vtp"), 0) << m_Errors;
  std::istringstream names(inputs);
  for (std::string name; names >> name;)
  {
    EXPECT_EQ(this->Run(name + " walls.vtp --spacing 0.5 0.5 1"), 0) << m_Errors;
    EXPECT_TRUE(ReadBytes(this->PathOf("walls.vtp")) == ReadBytes(this->PathOf("reference.vtp"))) << name;
  }
}

TEST_F(TissueTessellationApp, WarnsOfLostVoxelSizes)
{
  const auto   image = MakeSyntheticTestTissue<unsigned char>();
  const double unit[] = { 1.0, 1.0, 1.0 };
  image->SetSpacing(unit);
  this->WriteImage(image.GetPointer(), "tissue.tif");
  ASSERT_EQ(this->Run("tissue.tif walls.vtp --quiet --report report.json"), 0);
  EXPECT_NE(m_Errors.find("warning: the voxels are exactly 1 x 1 x 1"), std::string::npos) << m_Errors;
  EXPECT_EQ(m_Output, "");
  EXPECT_EQ(this->ReadReport()["warnings"].size(), 1u);
  ASSERT_EQ(this->Run("tissue.tif walls.vtp --quiet --spacing 1 1 1"), 0);
  EXPECT_EQ(m_Errors + m_Output, "");
  this->WriteTissue<unsigned char>("tissue.tif");
  ASSERT_EQ(this->Run("tissue.tif walls.vtp --quiet"), 0);
  EXPECT_NE(m_Errors.find("warning: the file tells no distance of its slices"), std::string::npos) << m_Errors;
}

TEST_F(TissueTessellationApp, PresetsCanBeOverriddenInAnyOrder)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  ASSERT_EQ(this->Run("--legality combinatorial --seed 5 tissue.mha walls.vtp --preset paper --report report.json"), 0);
  const Json options = this->ReadReport()["options"];
  EXPECT_EQ(options["preset"], "paper");
  EXPECT_EQ(options["legality"], "combinatorial");
  EXPECT_EQ(options["rings"], "delaunay");
  EXPECT_EQ(options["corners"], "circumcenter");
  EXPECT_EQ(options["seed"], 5);
  EXPECT_FALSE(options.contains("prefer")) << "of the other preset";
}

TEST_F(TissueTessellationApp, ReplacesOldOutputsOnSuccessAlone)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  std::ofstream(this->PathOf("walls.vtp")) << "old";
  EXPECT_EQ(this->Run("tissue.mha walls.vtp --exteriorLabel 99"), 1);
  EXPECT_EQ(ReadBytes(this->PathOf("walls.vtp")), "old");
  EXPECT_EQ(this->Run("tissue.mha walls.vtp"), 0);
  EXPECT_GT(ReadBytes(this->PathOf("walls.vtp")).size(), 1000u);
}
