/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Exports/MeshExport.h"
#include "TemporaryFolder.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

#include <cstring>
#include <iterator>

using namespace tissue;

namespace
{
/** Two cells of a voxel each beside each other, of labels 7 and 9. */
class MeshExport : public TemporaryFolderTest
{
protected:
  MeshExport()
    : m_Mesh(MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 }))
    , m_Cells(3)
  {
    m_Cells[1].label = 7;
    m_Cells[2].label = 9;
  }

  std::string
  Export(const std::string & name, const std::vector<Label> & labels = {}) const
  {
    const std::string path = this->PathOf("x");
    ExportMesh(m_Mesh, m_Cells, labels, m_Data, name, path);
    return ReadBytes(path);
  }

  static std::size_t
  CountLines(const std::string & text, const std::string & begin)
  {
    std::istringstream lines(text);
    std::size_t        number = 0;
    for (std::string line; std::getline(lines, line);)
    {
      number += line.rfind(begin, 0) == 0 ? 1 : 0;
    }
    return number;
  }

  WallMesh          m_Mesh;
  std::vector<Cell> m_Cells;
  ProjectedData     m_Data;
};
} // namespace

TEST_F(MeshExport, CellComplexHasTheColumnsOfNumbers)
{
  m_Data.ofCells = { { "growth rate", { 0.0, 0.25, 0.5 }, {} }, { "fate", {}, { "", "a", "b" } } };
  m_Data.ofWalls = { { "sMean", { 1.5, 2.5, 3.5 } } };
  const std::string text = this->Export("a.ply");
  EXPECT_NE(text.find("property int label\nproperty float growth_rate\nend_header\n"), std::string::npos) << text;
  EXPECT_NE(text.find("property int wall\nproperty float sMean\nelement edge"), std::string::npos) << text;
  EXPECT_EQ(text.find("fate"), std::string::npos);
  EXPECT_NE(text.find(" 7 0.25\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" 9 0.5\n"), std::string::npos) << text;
  EXPECT_NE(text.find(" 1 2.5\n"), std::string::npos) << text;
}

TEST_F(MeshExport, CellComplexHasWallsEdgesAndVolumes)
{
  const std::string text = this->Export("a.ply");
  for (const char * line : { "element vertex 12\n", "element face 22\n", "element edge 31\n", "element volume 2\n" })
  {
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  }
  const std::string body = text.substr(text.find("end_header\n") + 11);
  // Each cell has twelve faces, and its label.
  EXPECT_EQ(CountLines(body, "12 "), 2u);
  EXPECT_NE(body.find(" 7\n12 "), std::string::npos) << body;
  EXPECT_EQ(body.substr(body.size() - 3), " 9\n");
  // The four edges around the wall between the two cells are at three walls.
  std::istringstream lines(body);
  std::size_t        triples = 0;
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream       values(line);
    std::vector<std::string> words{ std::istream_iterator<std::string>(values), {} };
    triples += words.size() == 6 && words[2] == "3" ? 1 : 0;
  }
  EXPECT_EQ(triples, 4u);
  m_Cells[1].label = Label{ 1 } << 40;
  EXPECT_THROW(this->Export("a.ply"), std::runtime_error);
}

TEST_F(MeshExport, FacesHaveLabels)
{
  const std::string text = this->Export("a.mgx.ply");
  EXPECT_NE(text.find("element vertex 16\n"), std::string::npos) << text;
  EXPECT_NE(text.find("element face 24\n"), std::string::npos) << text;
  EXPECT_NE(text.find("3 8 "), std::string::npos) << "The second cell has points of its own." << text;
  const std::string chosen = this->Export("a.mgx.ply", { 9 });
  EXPECT_NE(chosen.find("element face 12\n"), std::string::npos) << chosen;
  EXPECT_EQ(chosen.find(" 7\n"), std::string::npos) << chosen;
}

TEST_F(MeshExport, WavefrontHasAGroupACell)
{
  const std::string text = this->Export("a.obj");
  EXPECT_EQ(CountLines(text, "g cell_7"), 1u);
  EXPECT_EQ(CountLines(text, "g cell_9"), 1u);
  EXPECT_EQ(CountLines(text, "v "), 16u);
  EXPECT_EQ(CountLines(text, "f "), 24u);
  EXPECT_EQ(text.find("f 0"), std::string::npos);
}

TEST_F(MeshExport, StlIsReadByVTK)
{
  ExportMesh(m_Mesh, m_Cells, { 7 }, m_Data, "a.stl", this->PathOf("a.stl"));
  const vtkNew<vtkSTLReader> reader;
  reader->SetFileName(this->PathOf("a.stl").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfCells(), 12);
  double bounds[6];
  reader->GetOutput()->GetBounds(bounds);
  EXPECT_EQ(bounds[1], 1.0);
}

TEST_F(MeshExport, GlTFHasANodeACell)
{
  const std::string bytes = this->Export("a.glb");
  std::uint32_t     header[5];
  ASSERT_GT(bytes.size(), sizeof(header));
  std::memcpy(header, bytes.data(), sizeof(header));
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(header[1], 2u);
  EXPECT_EQ(header[2], bytes.size());
  EXPECT_EQ(header[3] % 4, 0u);
  const auto json = nlohmann::json::parse(bytes.substr(20, header[3]));
  ASSERT_EQ(json["nodes"].size(), 3u);
  EXPECT_EQ(json["nodes"][0]["children"], (std::vector<int>{ 1, 2 }));
  EXPECT_EQ(json["nodes"][0]["translation"], (std::vector<double>{ 1.0, 0.5, 0.5 }));
  EXPECT_EQ(json["nodes"][1]["name"], "cell_7");
  EXPECT_EQ(json["nodes"][2]["name"], "cell_9");
  EXPECT_EQ(json["accessors"][0]["count"], 8);
  EXPECT_EQ(json["accessors"][0]["min"], (std::vector<float>{ -1.0f, -0.5f, -0.5f }));
  EXPECT_EQ(json["accessors"][1]["count"], 36);
  EXPECT_NE(json["materials"][0]["pbrMetallicRoughness"], json["materials"][1]["pbrMetallicRoughness"]);
  EXPECT_EQ(json["buffers"][0]["byteLength"], bytes.size() - 28 - header[3]);
}

TEST_F(MeshExport, RefusesLabelsAndNamesThatThereAreNot)
{
  EXPECT_THROW(this->Export("a.obj", { 8 }), std::runtime_error);
  EXPECT_THROW(this->Export("a.x3d"), std::invalid_argument);
  for (const std::string & ending : MeshExportEndings())
  {
    EXPECT_THROW(ExportMesh(m_Mesh, m_Cells, {}, m_Data, "a" + ending, this->PathOf("no/x")), std::runtime_error)
      << ending;
  }
}
