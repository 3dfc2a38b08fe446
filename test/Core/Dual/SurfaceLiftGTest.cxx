/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/CellCorners.h"
#include "Dual/SurfaceLift.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Points/PointJunctions.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace
{
using namespace tissue;

/** The middles of unit cubes in a block, moved a little, so that no four are in a plane. */
JunctionSet
MakeBlock(int nx, int ny, int nz)
{
  std::mt19937       random(5);
  const auto         jitter = [&random] { return 0.1 * (static_cast<double>(random() % 1000) / 1000.0 - 0.5); };
  std::vector<Point> points;
  for (int i = 0; i < nx * ny * nz; ++i)
  {
    points.push_back({ { i % nx + 0.5 + jitter(), i / nx % ny + 0.5 + jitter(), i / (nx * ny) + 0.5 + jitter() } });
  }
  std::vector<Label> labels(points.size());
  std::iota(labels.begin(), labels.end(), 1);
  return MakePointJunctions(points, labels);
}

ReconstructionParameters
Parameters(CornerRule corners)
{
  ReconstructionParameters parameters = ReconstructionParameters::PaperPointsPreset();
  parameters.annealing.numberOfCycles = 0;
  parameters.refinement = 0;
  parameters.smoothingIterations = 0;
  parameters.corners = corners;
  return parameters;
}

/** Volume of the cells of the block over what it is. */
double
VolumeOfBlock(CornerRule corners)
{
  const JunctionSet          block = MakeBlock(6, 6, 5);
  const TissueReconstruction tissue = ReconstructTissue(block, Parameters(corners));
  const CellSurfaceCheck     check = CheckCellSurfaces(tissue.walls, static_cast<VertexId>(block.cells.size()));
  double                     volume = 0.0;
  for (std::size_t v = 1; v < block.cells.size(); ++v)
  {
    volume += check.cells[v].volume;
  }
  return volume / 180.0;
}
} // namespace

TEST(SurfaceLift, CornersOfAFlatFaceAreHalfACellAboveTheCentres)
{
  const JunctionSet          block = MakeBlock(6, 6, 5);
  const TissueReconstruction tissue = ReconstructTissue(block, Parameters(CornerRule::LiftedCircumcenter));
  const AdjacencyComplex     complex(static_cast<VertexId>(block.cells.size()), tissue.tetrahedra);
  const auto                 low = ComputeCorners(complex, block, CornerRule::ProjectedCircumcenter);
  const auto                 lifted = ComputeCorners(complex, block, CornerRule::LiftedCircumcenter);
  const auto                 tetrahedra = complex.GetTetrahedra();
  int                        numberOfChecked = 0;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    const VertexQuadruple & t = tetrahedra[i];
    if (t[0] != ExteriorVertex)
    {
      // But for corners at one place, which are moved apart.
      EXPECT_LT(Distance(lifted[i], low[i]), 0.01);
      continue;
    }
    // Cells of the top, but not at its rim.
    const auto isTop = [&](VertexId v) {
      const Point & p = block.cells[v].center;
      return p[2] > 4.0 && p[0] > 1.0 && p[0] < 5.0 && p[1] > 1.0 && p[1] < 5.0;
    };
    if (isTop(t[1]) && isTop(t[2]) && isTop(t[3]))
    {
      EXPECT_NEAR(low[i][2], 4.5, 0.06);
      EXPECT_NEAR(lifted[i][2], 5.0, 0.12);
      ++numberOfChecked;
    }
  }
  EXPECT_GE(numberOfChecked, 15);
}

TEST(SurfaceLift, VolumeIsThatOfTheTissueNotOfTheHullOfItsCentres)
{
  // The hull of the centres has 5 x 5 x 4 of 6 x 6 x 5. Its rims are cut off: three cells at a rim have one outward
  // direction.
  EXPECT_NEAR(VolumeOfBlock(CornerRule::ProjectedCircumcenter), 100.0 / 180.0, 0.05);
  EXPECT_NEAR(VolumeOfBlock(CornerRule::LiftedCircumcenter), 0.85, 0.05);
}
