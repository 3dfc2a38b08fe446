/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Simulation/SimulationModel.h"
#include "TemporaryFolder.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
/** Two cells of a voxel each beside each other, of labels that no tag of Gmsh can be, and that one can. */
class SimulationModelOfTwoCells : public TemporaryFolderTest
{
protected:
  SimulationModelOfTwoCells()
    : m_Mesh(MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 }))
    , m_Cells(3)
  {
    m_Cells[1].label = 7;
    m_Cells[2].label = Label{ 1 } << 40;
  }

  /** What a model writes. */
  template <typename TWrite>
  std::string
  Written(const TWrite & write) const
  {
    const std::string path = this->PathOf("written");
    write(SimulationModel(m_Mesh, m_Cells), path);
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }

  WallMesh          m_Mesh;
  std::vector<Cell> m_Cells;
};
} // namespace

TEST_F(SimulationModelOfTwoCells, GmshGetsASurfaceAWall)
{
  const std::string text =
    Written([](const SimulationModel & model, const std::string & path) { model.WriteGmshWalls(path); });
  EXPECT_NE(text.find("$Nodes\n12\n1 "), std::string::npos) << text;
  EXPECT_NE(text.find("$Elements\n22\n1 2 2 0 1 "), std::string::npos) << text;
  EXPECT_NE(text.find("\n22 2 2 0 3 "), std::string::npos) << text;
}

TEST_F(SimulationModelOfTwoCells, GmshGetsAVolumeACellAndNames)
{
  const std::string text =
    Written([](const SimulationModel & model, const std::string & path) { model.WriteGmshModel(path, "tissue.msh"); });
  for (const char * line : { "Merge \"tissue.msh\";",
                             "Surface Loop(1) = {1, 2};\nVolume(1) = {1};",
                             "Surface Loop(2) = {2, 3};\nVolume(2) = {2};",
                             "Physical Volume(\"cell_7\", 7) = {1};",
                             "Physical Volume(\"cell_1099511627776\", 1) = {2};",
                             "Physical Surface(\"wall_7_0\", 1) = {1};",
                             "Physical Surface(\"wall_7_1099511627776\", 2) = {2};" })
  {
    EXPECT_NE(text.find(line), std::string::npos) << line << '\n' << text;
  }
  EXPECT_EQ(text.find("no volume"), std::string::npos);
}

TEST_F(SimulationModelOfTwoCells, TetGenGetsARegionACell)
{
  const std::string text =
    Written([](const SimulationModel & model, const std::string & path) { model.WriteTetGenModel(path); });
  EXPECT_NE(text.find("\n12 3 0 0\n0 "), std::string::npos) << text;
  EXPECT_NE(text.find("\n22 1\n3 "), std::string::npos) << text;
  EXPECT_NE(text.find("\n0\n2\n0 0"), std::string::npos) << text;
  EXPECT_NE(text.find(" 1099511627776\n"), std::string::npos) << text;
}

TEST_F(SimulationModelOfTwoCells, OpenCellsAreNamed)
{
  m_Mesh.triangles.pop_back();
  m_Mesh.wallOfTriangle.pop_back();
  const std::string text =
    Written([](const SimulationModel & model, const std::string & path) { model.WriteGmshModel(path, "tissue.msh"); });
  EXPECT_NE(text.find("// Cell 1099511627776 has no volume"), std::string::npos) << text;
  EXPECT_EQ(text.find("Volume(2)"), std::string::npos) << text;
}

TEST_F(SimulationModelOfTwoCells, FilesThatCannotBeWrittenAreErrors)
{
  const SimulationModel model(m_Mesh, m_Cells);
  EXPECT_THROW(model.WriteTetGenModel(this->PathOf("no/x.smesh")), std::runtime_error);
  m_Cells.pop_back();
  EXPECT_THROW(SimulationModel(m_Mesh, m_Cells), std::invalid_argument);
}

TEST(SimulationModel, KnowsTheFilesOfGmsh)
{
  EXPECT_TRUE(IsGmshModel("a/b.geo"));
  EXPECT_FALSE(IsGmshModel("a/b.smesh"));
  EXPECT_EQ(GmshWallsBeside("a.b/c.geo"), "a.b/c.msh");
}
