/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "Mesh/WallMeasures.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

using namespace tissue_test;

namespace
{
/** The preset with the fewest triangles. */
ReconstructionParameters
Coarse()
{
  ReconstructionParameters parameters;
  parameters.trianglesPerCell = 40.0;
  return parameters;
}

struct Ball
{
  explicit Ball(LabelVolume labels = VoronoiBall(24))
    : volume(std::move(labels))
    , junctions(JunctionsOf(volume))
  {}

  TissueReconstruction
  Reconstruct(const ReconstructionParameters & parameters = Coarse(), const Execution & execution = Execution()) const
  {
    return ReconstructTissue(junctions, parameters, &volume, execution);
  }

  LabelVolume volume;
  JunctionSet junctions;
};

bool
HasRemark(const TissueReconstruction & result, VertexId cell, Remark remark)
{
  return std::any_of(result.remarks.begin(), result.remarks.end(), [&](const CellRemark & r) {
    return r.cell == cell && r.remark == remark;
  });
}

std::string
MessageOf(const JunctionSet & junctions, const ReconstructionParameters & parameters)
{
  try
  {
    ReconstructTissue(junctions, parameters);
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return {};
}

/** Stars whose corners are at the image's junctions may have flat triangles; fitted walls have none. */
void
ExpectClosedCells(const WallMesh & walls, const JunctionSet & junctions)
{
  const CellSurfaceCheck check = CheckCellSurfaces(walls, static_cast<VertexId>(junctions.cells.size()));
  EXPECT_TRUE(check.cellsWithoutTriangles.empty());
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  EXPECT_TRUE(check.crowdedPoints.empty());
}

/** Cells at points, without adjacencies. */
JunctionSet
CellsAt(const std::vector<Point> & centers)
{
  JunctionSet junctions;
  junctions.cells.resize(centers.size() + 1);
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    junctions.cells[i + 1].label = static_cast<Label>(i + 1);
    junctions.cells[i + 1].center = centers[i];
  }
  return junctions;
}
} // namespace

TEST(TissueReconstruction, EveryCellIsAClosedSphereOfItsVolume)
{
  const Ball                 ball;
  const TissueReconstruction result = ball.Reconstruct();
  EXPECT_TRUE(result.isFitted);
  EXPECT_TRUE(CheckCellSurfaces(result.walls, ball.junctions.NumberOfVertices()).IsSound());
  const std::vector<double> volumes = ComputeVolumes(result.walls, ball.junctions.cells.size());
  for (VertexId v = 1; v < ball.junctions.NumberOfVertices(); ++v)
  {
    const bool isOff = std::abs(volumes[v] / ball.junctions.cells[v].volume - 1.0) > 0.01;
    EXPECT_EQ(isOff, HasRemark(result, v, Remark::VolumeNotFitted) || HasRemark(result, v, Remark::VolumeOff)) << v;
    EXPECT_FALSE(isOff) << v;
  }
}

TEST(TissueReconstruction, OfCentresTheWallsAreStarsAndTheVolumeDoesNotMatter)
{
  const Ball                 ball;
  const auto                 paper = ReconstructionParameters::PaperPreset();
  const TissueReconstruction result = ReconstructTissue(ball.junctions, paper);
  EXPECT_FALSE(result.isFitted);
  ExpectClosedCells(result.walls, ball.junctions);
  EXPECT_EQ(result.walls.points, ball.Reconstruct(paper).walls.points);
}

TEST(TissueReconstruction, StagesHaveTheirTuplesIfTheyAreToBeKept)
{
  const Ball ball;
  for (ReconstructionParameters parameters : { Coarse(), ReconstructionParameters::PaperPreset() })
  {
    EXPECT_TRUE(ball.Reconstruct(parameters).stages.back().tuples.pairs.empty());
    parameters.keepStages = true;
    const TissueReconstruction result = ball.Reconstruct(parameters);
    std::vector<VertexId>      ids(ball.junctions.cells.size());
    std::iota(ids.begin(), ids.end(), VertexId{ 0 });
    for (const ReconstructionStage & stage : result.stages)
    {
      const AdjacencyOverlap overlap = ComputeAdjacencyOverlap(stage.tuples, ids, ball.junctions);
      EXPECT_DOUBLE_EQ(overlap.adjacency2, stage.statistics.overlap.adjacency2);
      EXPECT_DOUBLE_EQ(overlap.adjacency4, stage.statistics.overlap.adjacency4);
    }
    EXPECT_EQ(result.stages.back().tuples.quadruples, AdjacencyTuples::Of(result.tetrahedra).quadruples);
    EXPECT_EQ(result.stages.back().name, "optimized");
  }
}

TEST(TissueReconstruction, OfTheImageNearlyAllPairsAreRight)
{
  const Ball                 ball;
  const TissueReconstruction result = ball.Reconstruct();
  EXPECT_GE(result.stages.back().statistics.overlap.adjacency2, 0.98);
  EXPECT_GE(result.stages.back().statistics.overlap.adjacency4OfNeighbors, 0.95);
}

TEST(TissueReconstruction, TheFirstPointsAreTheCornersOfTheTetrahedra)
{
  const Ball                      ball;
  const TissueReconstruction      result = ball.Reconstruct();
  std::vector<std::set<VertexId>> cellsAt(result.walls.points.size());
  for (std::size_t t = 0; t < result.walls.triangles.size(); ++t)
  {
    for (const PointId p : result.walls.triangles[t])
    {
      const VertexPair & cells = result.walls.walls[result.walls.wallOfTriangle[t]].cells;
      cellsAt[p].insert(cells.begin(), cells.end());
    }
  }
  for (std::size_t i = 0; i < result.tetrahedra.size(); ++i)
  {
    EXPECT_EQ(cellsAt[i], std::set<VertexId>(result.tetrahedra[i].begin(), result.tetrahedra[i].end())) << i;
  }
}

TEST(TissueReconstruction, CellsWithoutCornersHaveTheirWalls)
{
  // A box of two cells, with a third one inside the first, and a fourth apart.
  const auto labelAt = [](int x, int y, int z) {
    const auto isIn = [&](int x0, int x1, int low, int high) {
      return x >= x0 && x < x1 && std::min(y, z) >= low && std::max(y, z) < high;
    };
    return isIn(5, 10, 6, 11) ? 3 : isIn(2, 13, 3, 14) ? 1 : isIn(13, 22, 3, 14) ? 2 : isIn(26, 32, 4, 10) ? 4 : 0;
  };
  LabelVolume volume;
  volume.size = { { 35, 17, 17 } };
  for (int i = 0; i < 35 * 17 * 17; ++i)
  {
    volume.vertices.push_back(labelAt(i % 35, i / 35 % 17, i / 35 / 17));
  }
  const Ball                 box(volume);
  const TissueReconstruction result = box.Reconstruct();
  std::set<VertexPair>       pairs;
  for (const WallMesh::Wall & wall : result.walls.walls)
  {
    EXPECT_TRUE(pairs.insert(wall.cells).second) << "one wall of each pair";
  }
  EXPECT_EQ(pairs, (std::set<VertexPair>{ { { 1, 0 } }, { { 1, 2 } }, { { 1, 3 } }, { { 2, 0 } }, { { 4, 0 } } }));
  const CellSurfaceCheck check = CheckCellSurfaces(result.walls, 5);
  EXPECT_TRUE(check.cellsThatAreNoSphere.empty());
  EXPECT_EQ(check.cells[1].numberOfComponents, 2) << "around the third cell";
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  for (std::size_t v = 1; v < 5; ++v)
  {
    EXPECT_NEAR(check.cells[v].volume / box.junctions.cells[v].volume, 1.0, 0.01) << v;
  }
  EXPECT_TRUE(HasRemark(result, 3, Remark::Enclosed));
  EXPECT_TRUE(HasRemark(result, 4, Remark::Separated));
}

TEST(TissueReconstruction, IsTheSameForOneSeedAndAnyOrderOfWork)
{
  const Ball                 ball;
  const TissueReconstruction first = ball.Reconstruct();
  const TissueReconstruction second = ball.Reconstruct();
  const TissueReconstruction backwards = ball.Reconstruct(Coarse(), Execution(RunBackwards));
  for (const TissueReconstruction * const other : { &second, &backwards })
  {
    EXPECT_EQ(first.tetrahedra, other->tetrahedra);
    EXPECT_EQ(first.walls.points, other->walls.points);
    EXPECT_EQ(first.walls.triangles, other->walls.triangles);
    EXPECT_EQ(first.energy, other->energy);
  }
}

TEST(TissueReconstruction, ProgressAscendsToOne)
{
  std::vector<double> fractions;
  Ball().Reconstruct(Coarse(), Execution({}, [&fractions](double fraction) {
                       fractions.push_back(fraction);
                       return true;
                     }));
  ASSERT_GT(fractions.size(), 10u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GE(fractions.front(), 0.0);
  EXPECT_EQ(fractions.back(), 1.0);
}

TEST(TissueReconstruction, StopsWhereverItIsAskedTo)
{
  const Ball ball;
  for (const double limit : { 0.0, 0.1, 0.3, 0.5 })
  {
    double last = 0.0;
    EXPECT_THROW(ball.Reconstruct(Coarse(), Execution({}, [&](double fraction) { return (last = fraction) < limit; })),
                 Aborted);
    EXPECT_GE(last, limit);
    EXPECT_LT(last, 1.0);
  }
}

TEST(TissueReconstruction, AVoidIsExterior)
{
  LabelVolume volume = VoronoiBall(24, 4.0);
  const auto  hollow = *std::max_element(volume.vertices.begin(), volume.vertices.end());
  volume.vertices.Replace(hollow, ExteriorVertex);
  const Ball                 shell(volume);
  const TissueReconstruction result = shell.Reconstruct();
  ExpectClosedCells(result.walls, shell.junctions);
  const std::vector<double> volumes = ComputeVolumes(result.walls, shell.junctions.cells.size());
  for (std::size_t v = 1; v < volumes.size(); ++v)
  {
    EXPECT_NEAR(volumes[v] / shell.junctions.cells[v].volume, 1.0, 0.01) << v;
  }
}

TEST(TissueReconstruction, CellsWithOneCentreAreMovedApartByAThousandthOfTheirDistance)
{
  Ball ball;
  ball.junctions.cells[5].center = ball.junctions.cells[3].center;
  const double               step = 1e-3 * MedianNeighborDistance(ball.junctions);
  const TissueReconstruction result = ReconstructTissue(ball.junctions, ReconstructionParameters::PaperPreset());
  const auto                 at = std::find_if(
    result.remarks.begin(), result.remarks.end(), [](const CellRemark & r) { return r.remark == Remark::CenterMoved; });
  ASSERT_NE(at, result.remarks.end());
  EXPECT_EQ(at->cell, 5);
  EXPECT_NEAR(at->value, step, 1e-9);
  ExpectClosedCells(result.walls, ball.junctions);
}

TEST(TissueReconstruction, CellsWithoutKnownNeighboursHaveNoRemarks)
{
  const std::vector<Point>   centers = RandomCenters(30, 4);
  const TissueReconstruction result =
    ReconstructTissue(CellsAt({ centers.begin() + 1, centers.end() }), ReconstructionParameters::PaperPointsPreset());
  EXPECT_TRUE(result.remarks.empty());
  EXPECT_EQ(result.stages.back().statistics.overlap.adjacency2, 0.0);
  EXPECT_GT(result.maximumEdgeLength, 0.0);
  EXPECT_TRUE(CheckCellSurfaces(result.walls, 31).IsSound());
}

TEST(TissueReconstruction, RefusesWhatCannotBeDoneByMessage)
{
  const auto               paper = ReconstructionParameters::PaperPreset();
  const std::vector<Point> three{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };
  EXPECT_NE(MessageOf(CellsAt(three), paper).find("3 cells, at least 4 are needed"), std::string::npos);
  std::vector<Point> flat = three;
  flat.push_back({ { 1, 1, 0 } });
  EXPECT_NE(MessageOf(CellsAt(flat), paper).find("all 4 cell centres are coplanar"), std::string::npos);
  flat.back()[2] = 1.0;
  EXPECT_EQ(MessageOf(CellsAt(flat), paper), "");
  ReconstructionParameters parameters;
  EXPECT_NE(MessageOf(CellsAt(flat), parameters).find("needs the label volume"), std::string::npos);
  parameters.trianglesPerCell = 39.0;
  EXPECT_NE(MessageOf(CellsAt(flat), parameters).find("39, must be in 40 .. 10000"), std::string::npos);
}

TEST(TissueReconstruction, OtherLabelsOfTheSameCellsMakeAMeshOfTheSameWallsAndVolumes)
{
  const LabelVolume  volume = VoronoiBall(20);
  const JunctionSet  junctions = JunctionsOf(volume);
  const auto         last = junctions.NumberOfVertices() - 1;
  LabelVolume        shuffled = volume;
  const auto         other = [last](VertexId v) { return v == ExteriorVertex ? v : 1 + (7 * v) % last; };
  std::set<VertexId> all;
  for (VertexId v = 1; v <= last; ++v)
  {
    all.insert(other(v));
  }
  ASSERT_EQ(static_cast<VertexId>(all.size()), last) << "a permutation";
  for (std::size_t i = 0; i < volume.vertices.size(); ++i)
  {
    shuffled.vertices.Put(i, other(volume.vertices[i]));
  }
  const auto make = [](const LabelVolume & image) { return ReconstructTissue(JunctionsOf(image), Coarse(), &image); };
  const TissueReconstruction one = make(volume);
  const TissueReconstruction two = make(shuffled);
  EXPECT_EQ(one.walls.points, make(volume).walls.points) << "of the same labels it is the same to the last bit";
  EXPECT_EQ(one.walls.walls.size(), two.walls.walls.size());
  EXPECT_EQ(one.tetrahedra.size(), two.tetrahedra.size());
  const std::vector<double> before = ComputeVolumes(one.walls, junctions.cells.size());
  const std::vector<double> after = ComputeVolumes(two.walls, junctions.cells.size());
  for (VertexId v = 1; v <= last; ++v)
  {
    EXPECT_NEAR(after[other(v)] / before[v], 1.0, 1e-6) << v;
  }
}
