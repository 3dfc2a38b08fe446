/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Crossings.h"
#include "RandomLabelImage.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "VoxelTissue.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <set>

using namespace tissue;
using namespace tissue_test;

namespace
{
/** The number of images: all 10 000 where the environment says so, else what fits among other tests. */
std::uint64_t
NumberOfImages()
{
  const char * const text = std::getenv("TISSUE_RANDOM_IMAGES");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 64;
}

ReconstructionParameters
ParametersOf(std::uint64_t seed)
{
  ReconstructionParameters parameters;
  parameters.refinement = seed % 5 == 3 ? 0 : 1;
  parameters.preference = seed % 5 == 4 ? AdjacencyPreference::Junctions : AdjacencyPreference::Walls;
  return parameters;
}

/** The cells with a remark. */
std::set<VertexId>
CellsWith(const TissueReconstruction & result, Remark remark)
{
  std::set<VertexId> cells;
  for (const CellRemark & r : result.remarks)
  {
    if (r.remark == remark)
    {
      cells.insert(r.cell);
    }
  }
  return cells;
}

void
ExpectValid(const TissueReconstruction & result, const JunctionSet & junctions)
{
  const CellSurfaceCheck   check = CheckCellSurfaces(result.walls, junctions.NumberOfVertices());
  const std::set<VertexId> withHandles = CellsWith(result, Remark::HandlesKept);
  EXPECT_TRUE(check.cellsWithoutTriangles.empty()) << "cell " << check.cellsWithoutTriangles.front();
  for (const VertexId v : check.cellsThatAreNoSphere)
  {
    EXPECT_TRUE(check.cells[v].IsClosed()) << "cell " << v;
    EXPECT_EQ(withHandles.count(v), 1u) << "cell " << v << " is no sphere, and not named";
  }
  EXPECT_TRUE(check.crowdedPoints.empty());
  EXPECT_EQ(check.numberOfMiscountedPoints, 0);
  EXPECT_EQ(check.numberOfUnusedPoints, 0);
  EXPECT_EQ(FindCrossings(result.walls).size(), 0u);
  EXPECT_EQ(result.fitting.crossingPairs, 0);
  const std::set<VertexId> off = CellsWith(result, Remark::VolumeOff);
  for (VertexId v = ExteriorVertex + 1; v < junctions.NumberOfVertices(); ++v)
  {
    const double ratio = check.cells[v].volume / junctions.cells[v].volume;
    EXPECT_GT(ratio, 0.0) << "cell " << v;
    EXPECT_TRUE((ratio >= 0.5 && ratio <= 2.0) || off.count(v) > 0) << "cell " << v << " has " << ratio;
  }
}

double
ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}
} // namespace

TEST(RandomLabelImages, EachHasItsValidMeshInTwoSecondsAndAllOfItsCellsInIt)
{
  // Room for slow and busy machines, and for builds that are not optimized.
  constexpr double mostSeconds = 10.0;
  for (std::uint64_t seed = 0; seed < NumberOfImages() && !::testing::Test::HasFailure(); ++seed)
  {
    const RandomLabelImage image(seed);
    const LabelVolume      volume = image.MakeVolume();
    const JunctionSet      junctions = JunctionsOf(volume);
    SCOPED_TRACE(std::string(image.GetKind()) + ", seed " + std::to_string(seed));
    if (junctions.NumberOfVertices() < 2)
    {
      continue; // No cell at all, which the filters refuse.
    }
    const double               before = ProcessorSeconds();
    const TissueReconstruction result = ReconstructTissue(junctions, ParametersOf(seed), &volume);
    EXPECT_LT(ProcessorSeconds() - before, mostSeconds);
    ExpectValid(result, junctions);
  }
}

TEST(RandomLabelImages, WallsOfVoxelsAreThoseOfTheImageAndNamed)
{
  // Cells of one voxel each.
  LabelVolume volume;
  volume.size = { { 4, 3, 3 } };
  for (VertexId v = 1; v <= 36; ++v)
  {
    volume.vertices.push_back(v);
  }
  const JunctionSet          junctions = JunctionsOf(volume);
  const TissueReconstruction result = ReconstructTissue(junctions, ReconstructionParameters(), &volume);
  EXPECT_TRUE(result.fitting.isEmbedded);
  EXPECT_EQ(result.stages.back().name, "embedded");
  EXPECT_EQ(CellsWith(result, Remark::VoxelWalls).size(), 36u);
  const CellSurfaceCheck check = CheckCellSurfaces(result.walls, 37);
  EXPECT_TRUE(check.IsSound());
  for (VertexId v = 1; v <= 36; ++v)
  {
    EXPECT_NEAR(check.cells[v].volume, 1.0, 1e-9);
  }
  // The corners come first, in the order of the tetrahedra.
  ASSERT_GT(result.walls.points.size(), result.tetrahedra.size());
  EXPECT_EQ(result.walls.numberOfCells[result.tetrahedra.size() - 1], CellsAtCorner);
  EXPECT_NE(result.walls.numberOfCells[result.tetrahedra.size()], CellsAtCorner);
}
