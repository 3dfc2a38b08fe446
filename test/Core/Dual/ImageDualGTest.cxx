/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/ImageDual.h"
#include "Nerve/ImageTopology.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace tissue_test;

namespace
{
struct Dualized
{
  explicit Dualized(const LabelVolume & volume)
    : junctions(JunctionsOf(volume))
    , topology(FindImageTopology(volume, junctions.NumberOfVertices()))
  {
    std::vector<Point> centers;
    for (const Cell & cell : junctions.cells)
    {
      centers.push_back(cell.center);
    }
    dual = DualizeNerve(topology.nerve, topology.places.corners, topology.cellOf, centers);
  }

  JunctionSet   junctions;
  ImageTopology topology;
  ImageDual     dual;
};
} // namespace

TEST(ImageDual, HasAWallForEachEdgeALineForEachTriangleAndACornerForEachTetrahedron)
{
  const Dualized         ball(VoronoiBall(24));
  const DualMesh &       mesh = ball.dual.mesh;
  const GeneralComplex & complex = ball.topology.nerve.complex;
  EXPECT_EQ(mesh.corners.size(), complex.NumberOfTetrahedra());
  EXPECT_EQ(mesh.lines.size(), 2 * complex.NumberOfTetrahedra());
  EXPECT_EQ(mesh.walls.size(), complex.FindEdges().size());
  for (const DualMesh::Wall & wall : mesh.walls)
  {
    ASSERT_EQ(wall.corners.size(), wall.lines.size());
    for (std::size_t i = 0; i < wall.corners.size(); ++i)
    {
      const DualMesh::Line & line = mesh.lines[wall.lines[i]];
      std::array<PointId, 2> ends{ { wall.corners[i], wall.corners[(i + 1) % wall.corners.size()] } };
      ends = line.ends[0] == ends[0] ? ends : std::array<PointId, 2>{ { ends[1], ends[0] } };
      EXPECT_EQ(ends, line.ends);
      for (const VertexId cell : wall.cells)
      {
        EXPECT_EQ(std::count(line.cells.begin(), line.cells.end(), cell), 1);
      }
    }
  }
}

TEST(ImageDual, CornersAreAtTheJunctionsOfTheirCells)
{
  const Dualized ball(VoronoiBall(24));
  int            inImage = 0;
  for (std::size_t i = 0; i < ball.dual.mesh.corners.size(); ++i)
  {
    const Junction * const junction = FindJunction(ball.junctions, ball.dual.mesh.cellsOfCorner[i]);
    if (ball.dual.isInImage[i] && junction != nullptr && junction->numberOfClusters == 1)
    {
      EXPECT_LT(Distance(ball.dual.mesh.corners[i], junction->position), 3.0) << i;
      ++inImage;
    }
  }
  EXPECT_GT(inImage, 50);
}

TEST(ImageDual, WallsAreSeenCounterclockwiseFromTheirSecondCell)
{
  const Dualized     ball(VoronoiBall(24));
  int                right = 0;
  const WallMesh     mesh = TriangulateAsStars(ball.dual.mesh);
  std::vector<Point> normals(mesh.walls.size(), Point{ { 0, 0, 0 } });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle & p = mesh.triangles[t];
    Point &          normal = normals[mesh.wallOfTriangle[t]];
    normal = normal + Cross(mesh.points[p[1]] - mesh.points[p[0]], mesh.points[p[2]] - mesh.points[p[0]]);
  }
  int inner = 0;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    const VertexPair & cells = mesh.walls[w].cells;
    if (cells[1] != ExteriorVertex)
    {
      const Point way = ball.junctions.cells[cells[1]].center - ball.junctions.cells[cells[0]].center;
      ++inner;
      right += Dot(normals[w], way) > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(right, 0.95 * inner);
}

TEST(ImageDual, CornersOfFourCellsComeFirst)
{
  // A ball with a cell apart: its surface is made by dividing the exterior.
  LabelVolume volume = VoronoiBall(24);
  const auto  alone = *std::max_element(volume.vertices.begin(), volume.vertices.end()) + 1;
  for (int i = 0; i < 27; ++i)
  {
    volume.vertices.Put(static_cast<std::size_t>((1 + i / 9) * 24 + 1 + i / 3 % 3) * 24 + 1 + i % 3, alone);
  }
  const Dualized ball(volume);
  ASSERT_FALSE(ball.topology.divided.empty());
  std::vector<bool> areFour;
  for (VertexQuadruple cells : ball.dual.mesh.cellsOfCorner)
  {
    std::transform(cells.begin(), cells.end(), cells.begin(), [&](VertexId v) { return ball.topology.cellOf[v]; });
    areFour.push_back(AreDifferent(cells));
  }
  EXPECT_TRUE(std::is_sorted(areFour.rbegin(), areFour.rend()));
  EXPECT_FALSE(areFour.back());
}
