/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KuhnSimplex.h"
#include "RunBackwards.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Evaluation/ExteriorTopology.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

using namespace tissue;

namespace
{
/** A block of voxels, as an image and as the mesh of its voxel faces. */
struct VoxelBlock
{
  std::array<int, 3>    size;
  std::vector<VertexId> vertices;

  SurfaceTopology
  OfImage(const Execution & execution = Execution()) const
  {
    LabelVolume volume;
    volume.size = { { size[0], size[1], size[2] } };
    volume.vertices = vertices;
    return FindExteriorTopology(volume, execution);
  }

  SurfaceTopology
  OfMesh() const
  {
    return FindExteriorTopology(MakeVoxelWallMesh(size, vertices));
  }
};

void
ExpectTopology(const SurfaceTopology & topology, std::int64_t pieces, std::int64_t euler, std::int64_t genus)
{
  EXPECT_TRUE(topology.isClosed);
  EXPECT_EQ(topology.numberOfPieces, pieces);
  EXPECT_EQ(topology.eulerCharacteristic, euler);
  EXPECT_EQ(topology.Genus(), genus);
}

void
ExpectBoth(const VoxelBlock & block, std::int64_t pieces, std::int64_t euler, std::int64_t genus)
{
  ExpectTopology(block.OfImage(), pieces, euler, genus);
  ExpectTopology(block.OfMesh(), pieces, euler, genus);
}

/** The boundary by its definition: the simplices that it cuts are listed, and its faces joined at its edges. */
SurfaceTopology
TopologyByDefinition(const LabelVolume & volume)
{
  using Simplex = std::vector<VoxelIndex>;
  const auto isCell = [&](const VoxelIndex & v) { return volume.At(v[0], v[1], v[2]) != ExteriorVertex; };
  std::map<Simplex, std::int64_t> cut[5]; // by the number of vertices; the tetrahedra are numbered, triangles have one
  DisjointSets                    faces;
  const auto                      add = [&](const KuhnSimplex & tetrahedron) {
    for (int subset = 15; subset > 0; --subset)
    {
      Simplex simplex;
      for (int i = 0; i < 4; ++i)
      {
        if ((subset >> i & 1) != 0)
        {
          simplex.push_back(tetrahedron.voxels[i]);
        }
      }
      const auto cells = static_cast<std::size_t>(std::count_if(simplex.begin(), simplex.end(), isCell));
      if (cells == 0 || cells == simplex.size())
      {
        continue;
      }
      const auto face = simplex.size() == 4 ? faces.Add() : static_cast<std::int64_t>(faces.GetSize()) - 1;
      const auto inserted = cut[simplex.size()].emplace(simplex, face);
      if (simplex.size() == 3)
      {
        faces.Unite(face, inserted.first->second);
      }
    }
  };
  for (int z = -1; z < volume.size[2]; ++z)
  {
    for (int y = -1; y < volume.size[1]; ++y)
    {
      for (int x = -1; x < volume.size[0]; ++x)
      {
        for (int way = 0; way < 9; ++way)
        {
          if (way / 3 != way % 3)
          {
            add(KuhnSimplex::FromWay({ { x, y, z } }, way / 3, way % 3));
          }
        }
      }
    }
  }
  SurfaceTopology topology{ true, 0, 0 };
  topology.eulerCharacteristic = static_cast<std::int64_t>(cut[2].size()) - static_cast<std::int64_t>(cut[3].size()) +
                                 static_cast<std::int64_t>(cut[4].size());
  for (std::int64_t face = 0; face < static_cast<std::int64_t>(faces.GetSize()); ++face)
  {
    topology.numberOfPieces += faces.Find(face) == face ? 1 : 0;
  }
  return topology;
}
} // namespace

TEST(ExteriorTopology, SolidTissueHasASphere)
{
  ExpectBoth({ { { 2, 2, 1 } }, { 1, 2, 3, 4 } }, 1, 2, 0);
}

TEST(ExteriorTopology, RingOfCellsHasATorus)
{
  ExpectBoth({ { { 3, 3, 1 } }, { 1, 2, 3, 8, 0, 4, 7, 6, 5 } }, 1, 0, 1);
  ExpectBoth({ { { 5, 3, 1 } }, { 1, 1, 2, 2, 2, 1, 0, 2, 0, 3, 1, 1, 2, 3, 3 } }, 1, -2, 2);
}

TEST(ExteriorTopology, HollowTissueHasTwoSpheresAndSoHaveTwoTissues)
{
  VoxelBlock shell{ { { 3, 3, 3 } }, std::vector<VertexId>(27, 1) };
  std::fill_n(shell.vertices.begin(), 9, 2);
  shell.vertices[13] = 0;
  ExpectBoth(shell, 2, 4, 0);
  ExpectBoth({ { { 3, 1, 1 } }, { 1, 0, 1 } }, 2, 4, 0);
}

TEST(ExteriorTopology, WithoutCellsThereIsNoBoundary)
{
  ExpectTopology(VoxelBlock{ { { 2, 1, 1 } }, { 0, 0 } }.OfImage(), 0, 0, 0);
}

TEST(ExteriorTopology, VoxelsHangTogetherAlongOneDiagonalAndTheMeshTouchesItself)
{
  const VoxelBlock along{ { { 2, 2, 1 } }, { 1, 0, 0, 2 } };
  const VoxelBlock across{ { { 2, 2, 1 } }, { 0, 1, 2, 0 } };
  ExpectTopology(along.OfImage(), 1, 2, 0);
  ExpectTopology(across.OfImage(), 2, 4, 0);
  for (const VoxelBlock & block : { along, across })
  {
    EXPECT_FALSE(block.OfMesh().isClosed);
    EXPECT_EQ(block.OfMesh().Genus(), -1);
  }
  // In a point it may.
  ExpectTopology(VoxelBlock{ { { 2, 2, 2 } }, { 1, 0, 0, 0, 0, 0, 0, 1 } }.OfMesh(), 2, 4, 0);
}

TEST(ExteriorTopology, HoleAndTurnedTriangleOpenTheMesh)
{
  const WallMesh good = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  ExpectTopology(FindExteriorTopology(good), 1, 2, 0);
  ASSERT_EQ(good.walls[0].cells[1], ExteriorVertex);
  WallMesh mesh = good;
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  EXPECT_FALSE(FindExteriorTopology(mesh).isClosed);
  mesh = good;
  mesh.triangles.erase(mesh.triangles.begin());
  mesh.wallOfTriangle.erase(mesh.wallOfTriangle.begin());
  EXPECT_FALSE(FindExteriorTopology(mesh).isClosed);
  EXPECT_FALSE(FindExteriorTopology(WallMesh()).isClosed);
}

TEST(ExteriorTopology, OfNoiseIsThatOfTheDefinition)
{
  Random random(7);
  for (int i = 0; i < 40; ++i)
  {
    LabelVolume volume;
    volume.size = { { 1 + static_cast<int>(random.Index(6)),
                      1 + static_cast<int>(random.Index(6)),
                      1 + static_cast<int>(random.Index(6)) } };
    const int labels = 2 + random.Index(3);
    for (int i = 0; i < volume.size[0] * volume.size[1] * volume.size[2]; ++i)
    {
      volume.vertices.push_back(static_cast<VertexId>(random.Index(labels)));
    }
    const SurfaceTopology expected = TopologyByDefinition(volume);
    ExpectTopology(
      FindExteriorTopology(volume), expected.numberOfPieces, expected.eulerCharacteristic, expected.Genus());
    ExpectTopology(FindExteriorTopology(volume, Execution(tissue_test::RunBackwards)),
                   expected.numberOfPieces,
                   expected.eulerCharacteristic,
                   expected.Genus());
  }
}
