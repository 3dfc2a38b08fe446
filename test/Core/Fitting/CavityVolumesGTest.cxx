/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CavityVolumes.h"

#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

using namespace tissue;

namespace
{
/** Two cells of 6 x 7 x 7 voxels of volume 1 beside each other, in the layer of exterior about them. */
class CavityVolumesOfTwoCells : public testing::Test
{
protected:
  CavityVolumesOfTwoCells()
  {
    m_Volume.size = { { 14, 9, 9 } };
    m_Volume.origin = { { 0.5, 0.5, 0.5 } };
    for (int i = 0; i < 14 * 9 * 9; ++i)
    {
      const int  x = i % 14;
      const int  y = i / 14 % 9;
      const int  z = i / 14 / 9;
      const bool isCell = x > 0 && x < 13 && y > 0 && y < 8 && z > 0 && z < 8;
      m_Volume.vertices.push_back(!isCell ? ExteriorVertex : x < 7 ? 1 : 2);
    }
  }

  void
  Put(int x, int y, int z, VertexId vertex)
  {
    m_Volume.vertices.Put(static_cast<std::size_t>((z * 9 + y) * 14 + x), vertex);
  }

  /** The mesh of the image; vertices from 3 on become exterior in both, with walls of their own. */
  WallMesh
  MakeMesh()
  {
    WallMesh mesh = MakeVoxelWallMesh(m_Volume.size, { m_Volume.vertices.begin(), m_Volume.vertices.end() });
    for (WallMesh::Wall & wall : mesh.walls)
    {
      wall.cells[1] = wall.cells[1] > 2 ? ExteriorVertex : wall.cells[1];
    }
    for (const VertexId isVoid : { 3, 4, 5 })
    {
      m_Volume.vertices.Replace(isVoid, ExteriorVertex);
    }
    return mesh;
  }

  LabelVolume m_Volume;
};
} // namespace

TEST_F(CavityVolumesOfTwoCells, NoneWithoutVoids)
{
  const WallMesh      mesh = this->MakeMesh();
  const CavityVolumes cavities = FindCavityVolumes(mesh, 3, m_Volume);
  EXPECT_EQ(cavities.ofWall, std::vector<VertexId>(mesh.walls.size(), ExteriorVertex));
  EXPECT_TRUE(cavities.volumes.empty());
  EXPECT_TRUE(cavities.cellsOfFilledVoids.empty());
}

TEST_F(CavityVolumesOfTwoCells, VoidsOfOneCellAreCountedAndThoseBetweenCellsAreNot)
{
  // Two voxels and one within cell 2 and 1; one of each cell, a void between them.
  this->Put(9, 3, 3, 3);
  this->Put(10, 3, 3, 3);
  this->Put(3, 3, 3, 4);
  this->Put(6, 5, 5, 5);
  this->Put(7, 5, 5, 5);
  const WallMesh      mesh = this->MakeMesh();
  const CavityVolumes cavities = FindCavityVolumes(mesh, 3, m_Volume);
  EXPECT_EQ(cavities.volumes, (std::vector<double>{ 1.0, 2.0 }));
  EXPECT_TRUE(cavities.cellsOfFilledVoids.empty());
  // Walls by their cells: the cavities of cells 1 and 2 are vertices 3 and 4, all else is as it was.
  std::map<VertexPair, std::multiset<VertexId>> ofWalls;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    ofWalls[mesh.walls[w].cells].insert(cavities.ofWall[w]);
  }
  EXPECT_EQ((ofWalls[{ { 1, ExteriorVertex } }]), (std::multiset<VertexId>{ ExteriorVertex, 3, ExteriorVertex }));
  EXPECT_EQ((ofWalls[{ { 2, ExteriorVertex } }]), (std::multiset<VertexId>{ ExteriorVertex, 4, ExteriorVertex }));
  EXPECT_EQ((ofWalls[{ { 1, 2 } }]), std::multiset<VertexId>{ ExteriorVertex });
}

TEST_F(CavityVolumesOfTwoCells, VoidsThatTheMeshHasNotAreNamed)
{
  const WallMesh mesh = this->MakeMesh();
  for (const int x : { 3, 5, 10 })
  {
    this->Put(x, 3, 3, ExteriorVertex);
  }
  const CavityVolumes cavities = FindCavityVolumes(mesh, 3, m_Volume);
  EXPECT_TRUE(cavities.volumes.empty());
  EXPECT_EQ(cavities.cellsOfFilledVoids, (std::vector<VertexId>{ 1, 1, 2 }));
}
