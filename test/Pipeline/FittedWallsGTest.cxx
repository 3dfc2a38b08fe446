/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/Crossings.h"
#include "SyntheticTestTissue.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "Mesh/WallMeasures.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkCellWallMeshEvaluationCalculator.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using ImageType = itk::Image<unsigned short, 3>;
using FilterType = itk::LabelImageToCellWallMeshFilter<ImageType>;
using tissue::Point;
using tissue::operator-;

constexpr double Radius = 30.0;

struct Seed
{
  Point  position;
  double weight;
};

/** A Laguerre tessellation of a ball: each cell is where |x - position|^2 - weight is least. */
std::vector<Seed>
MakeSeeds()
{
  std::vector<Seed> seeds;
  tissue::Random    random(3);
  constexpr double  step = 17.0;
  for (int i = 0; i < 64; ++i)
  {
    const Point grid{ { step * (i % 4 - 1.5), step * (i / 4 % 4 - 1.5), step * (i / 16 - 1.5) } };
    Point       p = grid;
    for (double & x : p)
    {
      x += 0.35 * step * (2.0 * random.Uniform() - 1.0);
    }
    if (tissue::Norm(grid) < Radius)
    {
      seeds.push_back({ p, 30.0 * random.Uniform() });
    }
  }
  return seeds;
}

/** Labels are the seeds' numbers from 1, 0 outside of the ball. */
ImageType::Pointer
Voxelize(const std::vector<Seed> & seeds, bool isTurned)
{
  auto                image = ImageType::New();
  ImageType::SizeType size{ { 64, 64, 64 } };
  if (isTurned)
  {
    const double             spacing[3] = { 0.8, 1.0, 1.25 };
    const double             c = 0.6;
    const double             s = 0.8;
    ImageType::DirectionType direction;
    direction.SetIdentity();
    direction[0][0] = c;
    direction[0][1] = -s;
    direction[1][0] = s;
    direction[1][1] = c;
    image->SetSpacing(spacing);
    image->SetDirection(direction);
    size = { { 80, 64, 52 } };
  }
  image->SetRegions(size);
  itk::ContinuousIndex<double, 3> middle;
  for (unsigned int i = 0; i < 3; ++i)
  {
    middle[i] = 0.5 * static_cast<double>(size[i] - 1);
  }
  ImageType::PointType center;
  image->TransformContinuousIndexToPhysicalPoint(middle, center);
  ImageType::PointType origin;
  for (unsigned int i = 0; i < 3; ++i)
  {
    origin[i] = -center[i];
  }
  image->SetOrigin(origin);
  image->Allocate(true);
  for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    ImageType::PointType physical;
    image->TransformIndexToPhysicalPoint(it.GetIndex(), physical);
    const Point p{ { physical[0], physical[1], physical[2] } };
    double      least = 1e30;
    for (std::size_t i = 0; i < seeds.size() && tissue::Norm(p) < Radius; ++i)
    {
      const Point  v = p - seeds[i].position;
      const double power = tissue::Dot(v, v) - seeds[i].weight;
      if (power < least)
      {
        least = power;
        it.Set(static_cast<unsigned short>(i + 1));
      }
    }
  }
  return image;
}

/** Signed distance to the plane between two seeds. */
double
DistanceToPlane(const Point & p, const Seed & a, const Seed & b)
{
  const Point  u = p - a.position;
  const Point  v = p - b.position;
  const double difference = tissue::Dot(u, u) - a.weight - tissue::Dot(v, v) + b.weight;
  return difference / (2.0 * tissue::Distance(a.position, b.position));
}
} // namespace

class FittedLaguerreTissue : public ::testing::TestWithParam<bool>
{};

TEST_P(FittedLaguerreTissue, HasItsCornersWallsAndVolumes)
{
  const std::vector<Seed> seeds = MakeSeeds();
  const auto              filter = FilterType::New();
  filter->SetInput(Voxelize(seeds, GetParam()));
  filter->Update();
  const tissue::WallMesh & mesh = filter->GetOutput()->GetWallMesh();
  const auto &             reconstruction = filter->GetOutput()->GetReconstruction();

  // A corner's distance to each of its planes bounds that to the point where they meet.
  std::vector<double> corners;
  for (std::size_t i = 0; i < reconstruction.tetrahedra.size(); ++i)
  {
    const auto & t = reconstruction.tetrahedra[i];
    if (t[0] != tissue::ExteriorVertex)
    {
      double farthest = 0.0;
      for (int k = 1; k < 4; ++k)
      {
        farthest = std::max(farthest, std::abs(DistanceToPlane(mesh.points[i], seeds[t[0] - 1], seeds[t[k] - 1])));
      }
      corners.push_back(farthest);
    }
  }
  ASSERT_GT(corners.size(), 30u);
  std::sort(corners.begin(), corners.end());
  EXPECT_LT(corners[corners.size() / 2], 0.3);
  EXPECT_LT(corners[corners.size() * 9 / 10], 0.5);

  double      sum = 0.0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    for (const auto p : mesh.triangles[t])
    {
      if (cells[1] != tissue::ExteriorVertex && mesh.numberOfCells[p] == tissue::CellsWithinWall)
      {
        sum += std::abs(DistanceToPlane(mesh.points[p], seeds[cells[0] - 1], seeds[cells[1] - 1]));
        ++count;
      }
    }
  }
  EXPECT_LT(sum / static_cast<double>(count), 0.15) << "flat walls are flat";

  const auto & cells = filter->GetOutput()->GetJunctionSet().cells;
  const auto   volumes = tissue::ComputeVolumes(mesh, cells.size());
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    EXPECT_NEAR(volumes[v] / cells[v].volume, 1.0, 0.005);
  }
  EXPECT_TRUE(tissue::FindCrossings(mesh).empty());
}

INSTANTIATE_TEST_SUITE_P(Geometries, FittedLaguerreTissue, ::testing::Values(false, true));

TEST(FittedWalls, FollowACellThatIsBentRoundOthers)
{
  const std::vector<Seed> seeds = MakeSeeds();
  const auto              image = Voxelize(seeds, false);
  // Two thirds of the outermost cells' ring about the z-axis becomes one cell.
  std::vector<unsigned short> labels(seeds.size() + 1, 0);
  unsigned short              ring = 0;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    const Point & p = seeds[i].position;
    const bool    isInRing = std::hypot(p[0], p[1]) > 14.0 && std::abs(p[2]) < 14.0 && p[0] < 9.0;
    labels[i + 1] = static_cast<unsigned short>(i + 1);
    if (isInRing)
    {
      ring = ring == 0 ? labels[i + 1] : ring;
      labels[i + 1] = ring;
    }
  }
  for (itk::ImageRegionIteratorWithIndex<ImageType> it(image, image->GetBufferedRegion()); !it.IsAtEnd(); ++it)
  {
    it.Set(labels[it.Get()]);
  }
  const auto filter = FilterType::New();
  filter->SetInput(image);
  filter->Update();
  const auto evaluation = itk::CellWallMeshEvaluationCalculator<ImageType>::New();
  evaluation->SetMesh(filter->GetOutput());
  evaluation->SetImage(image);
  evaluation->Compute();
  EXPECT_LT(evaluation->GetEvaluation().distance.InVoxels(evaluation->GetEvaluation().distance.mean), 0.8);
  EXPECT_TRUE(tissue::FindCrossings(filter->GetOutput()->GetWallMesh()).empty());
}

TEST(FittedWalls, AreTheSameForAnyNumberOfThreads)
{
  std::vector<Point> first;
  for (const unsigned int threads : { 1, 2, 5 })
  {
    const auto filter = FilterType::New();
    filter->SetInput(MakeSyntheticTestTissue<unsigned short>());
    filter->SetNumberOfWorkUnits(threads);
    filter->Update();
    const auto & points = filter->GetOutput()->GetWallMesh().points;
    first = first.empty() ? points : first;
    EXPECT_EQ(points, first) << threads << " threads";
  }
}

TEST(FittedWalls, RefinementZeroIsTheFittedStarAlone)
{
  const auto filter = FilterType::New();
  filter->SetInput(MakeSyntheticTestTissue<unsigned short>());
  filter->SetRefinement(0);
  filter->Update();
  const auto & mesh = filter->GetOutput()->GetWallMesh();
  const auto & cells = filter->GetOutput()->GetJunctionSet().cells;
  EXPECT_TRUE(filter->GetOutput()->GetReconstruction().isFitted);
  // Some lines of the exterior have a point at their middle.
  const auto cornersAndCenters = filter->GetOutput()->GetReconstruction().tetrahedra.size() + mesh.walls.size();
  EXPECT_GE(mesh.points.size(), cornersAndCenters);
  EXPECT_LE(mesh.points.size(), cornersAndCenters + cornersAndCenters / 10);
  EXPECT_TRUE(tissue::FindCrossings(mesh).empty());
  const auto volumes = tissue::ComputeVolumes(mesh, cells.size());
  double     error = 0.0;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    error += std::abs(volumes[v] / cells[v].volume - 1.0) / static_cast<double>(cells.size() - 1);
  }
  EXPECT_LT(error, 0.035);
}
