/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/EmbeddedWalls.h"

#include "Mesh/Crossings.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace tissue;
using namespace tissue_test;

namespace
{
LabelVolume
MakeVolume(const std::array<std::int32_t, 3> & size, const std::vector<VertexId> & vertices)
{
  LabelVolume volume;
  volume.size = size;
  volume.vertices = VoxelVertices(vertices);
  return volume;
}

std::vector<VertexId>
Themselves(VertexId count)
{
  std::vector<VertexId> cells(static_cast<std::size_t>(count));
  std::iota(cells.begin(), cells.end(), ExteriorVertex);
  return cells;
}
} // namespace

TEST(EmbeddedWalls, OfNoiseAreClosedDoNotCrossAndHaveTheVoxelsVolumes)
{
  const VoxelImage image = Noise({ { 6, 5, 7 } }, 9);
  LabelVolume      volume = MakeVolume({ { 6, 5, 7 } }, {});
  volume.steps = { { { { 0.0, 2.0, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 0.5, 3.0 } } } }; // left-handed, sheared
  std::vector<double> volumes(9, 0.0);
  for (int i = 0; i < 6 * 5 * 7; ++i)
  {
    const auto v = static_cast<VertexId>(image.labelAt(i % 6, i / 6 % 5, i / 30));
    volume.vertices.push_back(v);
    volumes[v] += 6.0;
  }
  const EmbeddedWalls    walls = MakeEmbeddedWalls(volume, Themselves(9));
  const CellSurfaceCheck check = CheckCellSurfaces(walls.mesh, 9);
  for (VertexId v = 1; v < 9; ++v)
  {
    EXPECT_TRUE(check.cells[v].IsClosed());
    EXPECT_EQ(check.cells[v].numberOfCrowdedEdges, 0);
    EXPECT_NEAR(check.cells[v].volume, volumes[v], 1e-9);
  }
  EXPECT_TRUE(check.crowdedPoints.empty());
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_EQ(check.numberOfUnusedPoints, 0);
  EXPECT_EQ(check.numberOfDegenerateTriangles, 0);
  EXPECT_TRUE(FindCrossings(walls.mesh).empty());
  EXPECT_EQ(static_cast<std::int64_t>(walls.mesh.triangles.size()), CountEmbeddedTriangles(volume, Themselves(9)));
  EXPECT_TRUE(std::is_sorted(walls.tetrahedra.begin(), walls.tetrahedra.end()));
  EXPECT_EQ(std::count(walls.mesh.numberOfCells.begin(), walls.mesh.numberOfCells.end(), CellsAtCorner),
            static_cast<std::ptrdiff_t>(walls.tetrahedra.size()));
}

TEST(EmbeddedWalls, OneVoxelIsASphereOfItsVolumeWithOneWall)
{
  const EmbeddedWalls    walls = MakeEmbeddedWalls(MakeVolume({ { 1, 1, 1 } }, { 1 }), Themselves(2));
  const CellSurfaceCheck check = CheckCellSurfaces(walls.mesh, 2);
  EXPECT_TRUE(check.IsSound());
  EXPECT_EQ(walls.mesh.walls.size(), 1u);
  EXPECT_NEAR(check.cells[1].volume, 1.0, 1e-12);
  EXPECT_TRUE(walls.tetrahedra.empty());
}

TEST(EmbeddedWalls, PiecesOfACellHaveNoWallBetweenThem)
{
  const LabelVolume volume = MakeVolume({ { 3, 1, 1 } }, { 1, 2, 3 });
  const auto        numberOfWalls = [&](const std::vector<VertexId> & cellOf) {
    return MakeEmbeddedWalls(volume, cellOf).mesh.walls.size();
  };
  EXPECT_EQ(numberOfWalls({ 0, 1, 2, 3 }), 5u);
  EXPECT_EQ(numberOfWalls({ 0, 1, 1, 2 }), 3u);
}

TEST(EmbeddedWalls, TwoWallsOfTheSameCellsAreTwo)
{
  // Cell 2 in two places beside cell 1.
  const EmbeddedWalls walls = MakeEmbeddedWalls(MakeVolume({ { 5, 1, 1 } }, { 2, 1, 1, 1, 2 }), Themselves(3));
  const auto          isBetween = [](const WallMesh::Wall & wall) { return wall.cells == VertexPair{ { 1, 2 } }; };
  EXPECT_EQ(std::count_if(walls.mesh.walls.begin(), walls.mesh.walls.end(), isBetween), 2);
}
