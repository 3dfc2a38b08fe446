/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"
#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"
#include "TissueTessellationCore/Evaluation/WallMeshEvaluation.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

// All figures are derived by hand; FourCubes.h says what the four cubes have.

namespace
{
tissue::JunctionSet
MakeJunctions(std::size_t numberOfVertices, double volume, const std::vector<tissue::VertexPair> & pairs,
              const std::vector<tissue::VertexQuadruple> & quadruples)
{
  tissue::JunctionSet junctions;
  junctions.cells.resize(numberOfVertices);
  for (tissue::Cell & cell : junctions.cells)
  {
    cell.volume = volume;
  }
  for (const tissue::VertexPair & pair : pairs)
  {
    junctions.walls.emplace_back();
    junctions.walls.back().cells = pair;
  }
  for (const tissue::VertexQuadruple & quadruple : quadruples)
  {
    junctions.junctions.emplace_back();
    junctions.junctions.back().cells = quadruple;
  }
  return junctions;
}

const std::vector<tissue::VertexPair> pairsOfTwoCubes = { { { 0, 1 } }, { { 0, 2 } }, { { 1, 2 } } };
} // namespace

TEST(WallMeshEvaluation, PointOfFiveCellsStandsForEachFourOfThem)
{
  // The image has a ninth pair, 1 and 4, and two of the five quadruples at the ends of the edge.
  const auto junctions = MakeJunctions(5,
                                       0.8,
                                       { { { 0, 1 } },
                                         { { 0, 2 } },
                                         { { 0, 3 } },
                                         { { 0, 4 } },
                                         { { 1, 2 } },
                                         { { 1, 3 } },
                                         { { 1, 4 } },
                                         { { 2, 4 } },
                                         { { 3, 4 } } },
                                       { { { 0, 1, 2, 3 } }, { { 1, 2, 3, 4 } } });
  const auto evaluation = tissue::EvaluateWallMesh(FourCubes().mesh, junctions);
  EXPECT_EQ(evaluation.numberOfTriangles, 40u);
  EXPECT_EQ(evaluation.numberOfCells, 4u);
  EXPECT_EQ(evaluation.numberOfMissingCells, 0u);
  EXPECT_EQ(evaluation.numberOfSpheres, 4u);
  EXPECT_EQ(evaluation.numberOfCorners, 2u);
  EXPECT_EQ(evaluation.numberOfCrowdedCorners, 2u);
  EXPECT_DOUBLE_EQ(evaluation.meanVolumeError, 0.25);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency2, 8.0 / 9.0);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency4, 2.0 / 5.0);
  // Each of the quadruples has a pair of cubes that share the edge alone: 2 and 3, or 1 and 4 in the mesh.
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency4OfNeighbors, 0.0);
  EXPECT_EQ(evaluation.overlap.numberOfFalsePairs, 0u);
  EXPECT_EQ(evaluation.overlap.numberOfMissingPairs, 1u);
}

TEST(WallMeshEvaluation, GapIsNoNeighbour)
{
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  for (auto & wall : mesh.walls)
  {
    if (wall.cells == tissue::VertexPair{ { 1, 2 } })
    {
      wall.cells[1] = 3;
    }
  }
  const auto evaluation = tissue::EvaluateWallMesh(mesh, MakeJunctions(3, 1.0, pairsOfTwoCubes, {}));
  EXPECT_EQ(evaluation.numberOfCells, 2u);
  // The second cube lacks the side that it had with the first one.
  EXPECT_EQ(evaluation.numberOfClosedCells, 1u);
  EXPECT_EQ(evaluation.numberOfMissingCells, 0u);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency2, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency4, 0.0);
}

namespace
{
/** A mesh of the image's voxel faces, judged by the image. */
tissue::TissueMeshEvaluation
EvaluateVoxelFaces(const std::array<int, 3> & size, const std::vector<tissue::VertexId> & vertices)
{
  tissue::LabelVolume volume;
  volume.size = { { size[0], size[1], size[2] } };
  volume.vertices = vertices;
  volume.origin = { { 0.5, 0.5, 0.5 } };
  return tissue::EvaluateTissueMesh(MakeVoxelWallMesh(size, vertices), tissue_test::JunctionsOf(volume), volume);
}
} // namespace

TEST(WallMeshEvaluation, MeshOfVoxelFacesHasAllAdjacencies)
{
  // Random labels: most blocks are of five cells and more.
  tissue::Random                random(3);
  std::vector<tissue::VertexId> vertices(512);
  std::generate(vertices.begin(), vertices.end(), [&random] { return 1 + random.Index(12); });
  const auto evaluation = EvaluateVoxelFaces({ { 8, 8, 8 } }, vertices);
  EXPECT_DOUBLE_EQ(evaluation.mesh.overlap.adjacency2, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.mesh.overlap.adjacency4, 1.0);
  EXPECT_DOUBLE_EQ(evaluation.mesh.overlap.adjacency4OfNeighbors, 1.0);
  EXPECT_EQ(evaluation.separateWalls.numberOfKeptPairs, evaluation.separateWalls.numberOfPairs);
  EXPECT_EQ(evaluation.exteriorOfImage.Genus(), 0);
  EXPECT_EQ(evaluation.exteriorOfMesh.Genus(), 0);
}

TEST(WallMeshEvaluation, CellAroundAnotherIsOfSpheres)
{
  std::vector<tissue::VertexId> vertices(27, 1);
  vertices[13] = 2;
  const auto evaluation = EvaluateVoxelFaces({ { 3, 3, 3 } }, vertices);
  EXPECT_EQ(evaluation.mesh.numberOfClosedCells, 2u);
  EXPECT_EQ(evaluation.mesh.numberOfCellsOfSpheres, 2u);
  EXPECT_EQ(evaluation.mesh.numberOfSpheres, 1u);
  EXPECT_TRUE(evaluation.mesh.cells[1].hasOnlySpheres);
  EXPECT_EQ(evaluation.mesh.cells[1].numberOfPieces, 2);
  EXPECT_EQ(evaluation.mesh.cells[2].numberOfPieces, 1);
  EXPECT_NEAR(evaluation.mesh.meanVolumeError, 0.0, 1e-12);
}

TEST(WallMeshEvaluation, RingOfCellsAndItsExteriorAreJudged)
{
  // Two cells that meet on two sides of a hole, in walls of 12 faces each.
  std::vector<tissue::VertexId> vertices;
  for (int i = 0; i < 9 * 4 * 4; ++i)
  {
    const int x = i % 9;
    const int y = i / 9 % 4;
    vertices.push_back(x >= 3 && x < 6 && y >= 1 && y < 3 ? tissue::ExteriorVertex : y < 2 ? 1 : 2);
  }
  const auto evaluation = EvaluateVoxelFaces({ { 9, 4, 4 } }, vertices);
  EXPECT_EQ(evaluation.separateWalls.numberOfPairs, 1u);
  EXPECT_EQ(evaluation.separateWalls.numberOfKeptPairs, 1u);
  EXPECT_EQ(evaluation.exteriorOfImage.Genus(), 1);
  EXPECT_EQ(evaluation.exteriorOfMesh.Genus(), 1);
  EXPECT_EQ(evaluation.exteriorOfMesh.numberOfPieces, 1);
}

TEST(WallMeshEvaluation, CellWithoutTriangleIsMissing)
{
  const auto mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  const auto evaluation = tissue::EvaluateWallMesh(mesh, MakeJunctions(4, 1.0, pairsOfTwoCubes, {}));
  EXPECT_EQ(evaluation.numberOfCells, 3u);
  EXPECT_EQ(evaluation.numberOfMissingCells, 1u);
  EXPECT_EQ(evaluation.numberOfSpheres, 2u);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency2, 1.0);
}

TEST(WallMeshEvaluation, CubesInTwoHalves)
{
  const auto mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  const auto evaluation = tissue::EvaluateWallMesh(mesh, MakeJunctions(3, 1.0, pairsOfTwoCubes, {}));
  EXPECT_EQ(evaluation.numberOfTriangles, 22u);
  EXPECT_EQ(evaluation.numberOfClosedCells, 2u);
  EXPECT_EQ(evaluation.numberOfSpheres, 2u);
  EXPECT_EQ(evaluation.numberOfCorners, 0u);
  EXPECT_DOUBLE_EQ(evaluation.overlap.adjacency2, 1.0);
  EXPECT_NEAR(evaluation.meanVolumeError, 0.0, 1e-12);
  EXPECT_NEAR(evaluation.volumeErrorPercentile95, 0.0, 1e-12);
  EXPECT_DOUBLE_EQ(evaluation.shareWithinOnePercent, 1.0);
  EXPECT_NEAR(evaluation.meanConvexity, 1.0, 1e-12);
  // Halves of unit squares: 4 sqrt(3) / 2 / (1 + 1 + 2).
  EXPECT_NEAR(evaluation.quality.mean, std::sqrt(3.0) / 2.0, 1e-12);
  EXPECT_NEAR(evaluation.quality.least, std::sqrt(3.0) / 2.0, 1e-12);
  EXPECT_EQ(evaluation.numberOfDegenerateTriangles, 0u);
  EXPECT_EQ(evaluation.numberOfCrossings, 0u);
  for (int v = 1; v < 3; ++v)
  {
    EXPECT_EQ(evaluation.cells[v].eulerCharacteristic, 2);
    EXPECT_TRUE(evaluation.cells[v].isSphere);
  }
}

TEST(WallMeshEvaluation, HoleOpensItsCells)
{
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  const auto       isExterior = mesh.walls[mesh.wallOfTriangle[0]].cells[1] == tissue::ExteriorVertex;
  mesh.triangles.erase(mesh.triangles.begin());
  mesh.wallOfTriangle.erase(mesh.wallOfTriangle.begin());
  const auto evaluation = tissue::EvaluateWallMesh(mesh, MakeJunctions(3, 1.0, pairsOfTwoCubes, {}));
  EXPECT_EQ(evaluation.numberOfClosedCells, isExterior ? 1u : 0u);
  EXPECT_DOUBLE_EQ(evaluation.shareWithinOnePercent, isExterior ? 0.5 : 0.0);
}

TEST(WallMeshEvaluation, TurnedTriangleOpensItsCells)
{
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (mesh.walls[mesh.wallOfTriangle[t]].cells == tissue::VertexPair{ { 1, 2 } })
    {
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      break;
    }
  }
  const auto evaluation = tissue::EvaluateWallMesh(mesh, MakeJunctions(3, 1.0, pairsOfTwoCubes, {}));
  EXPECT_EQ(evaluation.numberOfClosedCells, 0u);
  EXPECT_EQ(evaluation.cells[1].volumeError, -1.0);
  EXPECT_EQ(evaluation.meanVolumeError, -1.0);
  EXPECT_EQ(evaluation.volumeErrorPercentile95, -1.0);
  EXPECT_EQ(evaluation.meanConvexity, -1.0);
  EXPECT_EQ(evaluation.shareWithinOnePercent, 0.0);
}

TEST(WallMeshEvaluation, CrossingAndDegenerateTrianglesAreCounted)
{
  tissue::LabelledTriangles triangles;
  triangles.points = { { { 0, 0, 0 } }, { { 2, 0, 0 } }, { { 0, 2, 0 } },  { { 0.5, 0.5, -1 } }, { { 0.5, 0.5, 1 } },
                       { { 3, 3, 0 } }, { { 9, 0, 0 } }, { { 10, 0, 0 } }, { { 11, 0, 0 } } };
  triangles.triangles = { { { { 0, 1, 2 } }, { { 1, 0 } } },
                          { { { 3, 4, 5 } }, { { 2, 0 } } },
                          { { { 6, 7, 8 } }, { { 1, 2 } } } };
  const auto evaluation =
    tissue::EvaluateWallMesh(tissue::MakeWallMesh(triangles), MakeJunctions(3, 1.0, pairsOfTwoCubes, {}));
  EXPECT_EQ(evaluation.numberOfCrossings, 1u);
  EXPECT_EQ(evaluation.numberOfDegenerateTriangles, 1u);
  EXPECT_EQ(evaluation.quality.least, 0.0);
}

TEST(LabelledTriangles, BecomeWallsWhateverTheirOrderAndSides)
{
  const FourCubes           cubes;
  tissue::LabelledTriangles triangles;
  triangles.points = cubes.mesh.points;
  // A point that no triangle has.
  triangles.points.insert(triangles.points.begin(), { { 9.0, 9.0, 9.0 } });
  for (std::size_t t = cubes.mesh.triangles.size(); t-- > 0;)
  {
    const auto & p = cubes.mesh.triangles[t];
    const auto & cells = cubes.mesh.walls[cubes.mesh.wallOfTriangle[t]].cells;
    if (t % 2 == 0)
    {
      triangles.triangles.push_back({ { { p[0] + 1, p[1] + 1, p[2] + 1 } }, cells });
    }
    else
    {
      triangles.triangles.push_back({ { { p[0] + 1, p[2] + 1, p[1] + 1 } }, { { cells[1], cells[0] } } });
    }
  }
  const tissue::WallMesh mesh = tissue::MakeWallMesh(triangles);
  EXPECT_EQ(mesh.points, cubes.mesh.points);
  EXPECT_EQ(mesh.triangles.size(), 40u);
  ASSERT_EQ(mesh.walls.size(), 8u);
  EXPECT_TRUE(std::is_sorted(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end()));
  for (const auto & wall : mesh.walls)
  {
    EXPECT_TRUE(wall.cells[1] == tissue::ExteriorVertex || (wall.cells[0] > 0 && wall.cells[0] < wall.cells[1]));
  }
  const auto check = tissue::CheckCellSurfaces(mesh, 5);
  for (int v = 1; v < 5; ++v)
  {
    EXPECT_TRUE(check.cells[v].IsSphere());
    EXPECT_DOUBLE_EQ(check.cells[v].volume, 1.0);
  }
}

TEST(LabelledTriangles, RefusesATriangleWithinACellAndAPointOutOfRange)
{
  tissue::LabelledTriangles triangles;
  triangles.points.resize(3);
  triangles.triangles = { { { { 0, 1, 2 } }, { { 4, 4 } } } };
  EXPECT_THROW(tissue::MakeWallMesh(triangles), std::invalid_argument);
  triangles.triangles = { { { { 0, 1, 3 } }, { { 1, 0 } } } };
  EXPECT_THROW(tissue::MakeWallMesh(triangles), std::invalid_argument);
}

TEST(LabelledTriangles, OfLabelsAreJoinedWhereTheirPointsAre)
{
  // Each triangle with points of its own.
  const auto          cubes = MakeVoxelWallMesh({ { 2, 1, 1 } }, { 1, 2 });
  tissue::JunctionSet junctions = MakeJunctions(3, 1.0, pairsOfTwoCubes, {});
  junctions.cells[0].label = 5;
  junctions.cells[1].label = -4;
  junctions.cells[2].label = 7;
  tissue::TrianglesOfLabels soup;
  for (std::size_t t = 0; t < cubes.triangles.size(); ++t)
  {
    const auto   n = static_cast<tissue::PointId>(soup.points.size());
    const auto & cells = cubes.walls[cubes.wallOfTriangle[t]].cells;
    for (const tissue::PointId p : cubes.triangles[t])
    {
      soup.points.push_back(cubes.points[p]);
    }
    soup.triangles.push_back(
      { { { n, n + 1, n + 2 } }, { { junctions.cells[cells[0]].label, junctions.cells[cells[1]].label } } });
  }
  const auto mesh = tissue::MakeWallMesh(tissue::FindCellsOfTriangles(soup, junctions));
  EXPECT_EQ(mesh.points.size(), 12u);
  const auto evaluation = tissue::EvaluateWallMesh(mesh, junctions);
  EXPECT_EQ(evaluation.numberOfSpheres, 2u);
  EXPECT_EQ(evaluation.numberOfCrossings, 0u);

  soup.triangles[3].labels[0] = 6;
  EXPECT_THROW(tissue::FindCellsOfTriangles(soup, junctions), std::invalid_argument);
  soup.triangles[3].labels[0] = 7;
  soup.triangles[3].points[2] = 1000;
  EXPECT_THROW(tissue::FindCellsOfTriangles(soup, junctions), std::invalid_argument);
  soup.triangles[3].points[2] = 2;
  soup.points[2][0] = std::nan("");
  EXPECT_THROW(tissue::FindCellsOfTriangles(soup, junctions), std::invalid_argument);
}
