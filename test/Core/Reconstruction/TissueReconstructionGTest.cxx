/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TestWallMeshes.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Mesh/WallMeasures.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
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
  explicit Ball(double hollowRadius = 0.0)
    : volume(VoronoiBall(24, hollowRadius))
    , junctions(JunctionsOf(volume, hollowRadius > 0.0 ? 1 : 0))
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
MessageOf(const JunctionSet & junctions, const ReconstructionParameters & parameters = ReconstructionParameters())
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
  EXPECT_EQ(result.numberOfParts, 1u);
  EXPECT_TRUE(CheckCellSurfaces(result.walls, ball.junctions.NumberOfVertices()).IsSound());
  const std::vector<double> volumes = ComputeVolumes(result.walls, ball.junctions.cells.size());
  for (VertexId v = 1; v < ball.junctions.NumberOfVertices(); ++v)
  {
    const bool isOff = std::abs(volumes[v] / ball.junctions.cells[v].volume - 1.0) > 0.01;
    EXPECT_EQ(isOff, HasRemark(result, v, Remark::VolumeNotFitted) || HasRemark(result, v, Remark::VolumeOff)) << v;
    EXPECT_FALSE(isOff) << v;
  }
}

TEST(TissueReconstruction, WithoutAVolumeTheWallsAreNotFitted)
{
  const Ball                 ball;
  const TissueReconstruction result = ReconstructTissue(ball.junctions, ReconstructionParameters());
  EXPECT_FALSE(result.isFitted);
  ExpectClosedCells(result.walls, ball.junctions);
  EXPECT_EQ(result.tetrahedra, ball.Reconstruct().tetrahedra);
}

TEST(TissueReconstruction, StagesHaveTheirTetrahedraIfTheyAreToBeKept)
{
  const Ball               ball;
  ReconstructionParameters parameters;
  EXPECT_TRUE(ReconstructTissue(ball.junctions, parameters).optimized.tetrahedra.empty());
  parameters.keepStages = true;
  const TissueReconstruction result = ReconstructTissue(ball.junctions, parameters);
  std::vector<VertexId>      ids(ball.junctions.cells.size());
  std::iota(ids.begin(), ids.end(), VertexId{ 0 });
  for (const ReconstructionStage * const stage : { &result.delaunay, &result.cleaned, &result.optimized })
  {
    EXPECT_EQ(stage->tetrahedra.size(), stage->statistics.numberOfTetrahedra);
    const AdjacencyOverlap overlap = ComputeAdjacencyOverlap(stage->tetrahedra, ids, ball.junctions);
    EXPECT_DOUBLE_EQ(overlap.adjacency2, stage->statistics.overlap.adjacency2);
    EXPECT_DOUBLE_EQ(overlap.adjacency4, stage->statistics.overlap.adjacency4);
  }
  EXPECT_GT(result.optimized.statistics.overlap.adjacency4, result.delaunay.statistics.overlap.adjacency4);
  EXPECT_EQ(result.optimized.tetrahedra, result.tetrahedra);
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

TEST(TissueReconstruction, AVoidIsTheExteriorInTheEnd)
{
  const Ball shell(4.0);
  ASSERT_EQ(shell.junctions.voids.size(), 1u);
  const auto numberOfCells = static_cast<VertexId>(shell.junctions.cells.size());
  for (const bool separateVoids : { true, false })
  {
    ReconstructionParameters parameters = Coarse();
    parameters.separateVoids = separateVoids;
    const TissueReconstruction result = shell.Reconstruct(parameters);
    EXPECT_EQ(result.numberOfVoids, separateVoids ? 1u : 0u);
    for (const VertexQuadruple & t : result.tetrahedra)
    {
      EXPECT_LT(*std::max_element(t.begin(), t.end()), numberOfCells);
    }
    for (const WallMesh::Wall & wall : result.walls.walls)
    {
      EXPECT_LT(std::max(wall.cells[0], wall.cells[1]), numberOfCells);
    }
    ExpectClosedCells(result.walls, shell.junctions);
  }
}

TEST(TissueReconstruction, CellsWithOneCentreAreMovedApartByAThousandthOfTheirDistance)
{
  Ball ball;
  ball.junctions.cells[5].center = ball.junctions.cells[3].center;
  const double               step = 1e-3 * MedianNeighborDistance(ball.junctions);
  const TissueReconstruction result = ReconstructTissue(ball.junctions, ReconstructionParameters());
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
  EXPECT_EQ(result.optimized.statistics.overlap.adjacency2, 0.0);
  EXPECT_GT(result.maximumEdgeLength, 0.0);
  EXPECT_TRUE(CheckCellSurfaces(result.walls, 31).IsSound());
}

TEST(TissueReconstruction, RefusesWhatCannotBeDoneByMessage)
{
  const std::vector<Point> three{ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } };
  EXPECT_NE(MessageOf(CellsAt(three)).find("3 cells, at least 4 are needed"), std::string::npos);
  std::vector<Point> flat = three;
  flat.push_back({ { 1, 1, 0 } });
  EXPECT_NE(MessageOf(CellsAt(flat)).find("all 4 cell centres are coplanar"), std::string::npos);
  flat.back()[2] = 1.0;
  EXPECT_EQ(MessageOf(CellsAt(flat)), "");
  ReconstructionParameters parameters;
  parameters.trianglesPerCell = 39.0;
  EXPECT_NE(MessageOf(CellsAt(flat), parameters).find("39, must be in 40 .. 10000"), std::string::npos);
}
