/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/VolumeFitting.h"
#include "TestWallMeshes.h"
#include "Mesh/WallMeasures.h"

#include <gtest/gtest.h>

using namespace tissue_test;

TEST(VolumeFitting, VolumesByHand)
{
  // The corners are the centres of regular tetrahedra's opposite sides, three units from each other's planes.
  const std::vector<double> volumes = ComputeVolumes(FourCells(), 5);
  const std::vector<double> stretched = ComputeVolumes(FourCells({ { 2.0, 3.0, 0.5 } }), 5);
  EXPECT_EQ(volumes[ExteriorVertex], 0.0);
  for (VertexId v = 1; v < 5; ++v)
  {
    EXPECT_NEAR(volumes[v], 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(stretched[v], 3.0 * volumes[v], 1e-12);
  }
}

TEST(VolumeFitting, CellsReachTheirVolumes)
{
  WallMesh                  mesh = RoundOrange(3);
  const std::vector<double> before = ComputeVolumes(mesh, 4);
  const std::vector<double> wanted{ 0.0, 1.2 * before[1], 0.9 * before[2], before[3] };
  for (int step = 0; step < 6; ++step)
  {
    FitVolumes(mesh, wanted, 0.15);
  }
  const std::vector<double> after = ComputeVolumes(mesh, 4);
  for (VertexId v = 1; v < 4; ++v)
  {
    EXPECT_NEAR(after[v] / wanted[v], 1.0, 1e-6);
  }
}

TEST(VolumeFitting, OneStepChangesAVolumeByTheLargestShareOfTheWantedOne)
{
  WallMesh                  mesh = RoundOrange(3);
  const std::vector<double> before = ComputeVolumes(mesh, 4);
  FitVolumes(mesh, { 0.0, 2.0 * before[1], before[2], before[3] }, 0.05);
  const std::vector<double> after = ComputeVolumes(mesh, 4);
  EXPECT_NEAR(after[1] / before[1], 1.1, 0.01);
  EXPECT_NEAR(after[2] / before[2], 1.0, 0.01);
}

TEST(VolumeFitting, ACellWithoutAWantedVolumeKeepsItsOwn)
{
  WallMesh                  mesh = RoundOrange(3);
  const std::vector<double> before = ComputeVolumes(mesh, 4);
  FitVolumes(mesh, { 0.0, 1.05 * before[1], 0.0, before[3] }, 0.15);
  EXPECT_NEAR(ComputeVolumes(mesh, 4)[2] / before[2], 1.0, 5e-3);
  WallMesh       same = mesh;
  const WallMesh kept = mesh;
  FitVolumes(same, { 0.0, 0.0, 0.0, 0.0 }, 0.15);
  EXPECT_EQ(same.points, kept.points);
}

TEST(VolumeFitting, RefusesPointsWhereMoreCellsMeetThanTold)
{
  WallMesh mesh = RoundOrange(1);
  mesh.numberOfCells.assign(mesh.points.size(), 1);
  EXPECT_THROW(FitVolumes(mesh, { 0.0, 1.0, 1.0, 1.0 }, 0.15), std::invalid_argument);
}
