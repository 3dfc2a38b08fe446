/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelImageTestHelpers.h"
#include "SyntheticTestTissue.h"
#include "VoxelWallMesh.h"
#include "itkCellWallMeshEvaluationCalculator.h"
#include "itkLabelImageToCellWallMeshFilter.h"

#include <gtest/gtest.h>

#include <cmath>

// Figures derived by hand of the four cubes of MakeFourCubes(): 10, 20, 30 and 40 around an edge of four voxels.

namespace
{
using ImageType = itk::Image<short, 3>;
using CalculatorType = itk::CellWallMeshEvaluationCalculator<ImageType>;

/** The sides of the four cubes, two triangles each, each triangle with points of its own. */
std::shared_ptr<tissue::TrianglesOfLabels>
MakeTriangles(const ImageType * image, tissue::Label exterior = 0)
{
  const auto mesh = MakeVoxelWallMesh({ { 2, 2, 1 } }, { 1, 2, 3, 4 });
  const auto triangles = std::make_shared<tissue::TrianglesOfLabels>();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto n = static_cast<tissue::PointId>(triangles->points.size());
    for (const tissue::PointId p : mesh.triangles[t])
    {
      itk::ContinuousIndex<double, 3> index;
      for (int i = 0; i < 3; ++i)
      {
        index[i] = 1.5 + 4.0 * mesh.points[p][i];
      }
      itk::Point<double, 3> place;
      image->TransformContinuousIndexToPhysicalPoint(index, place);
      triangles->points.push_back({ { place[0], place[1], place[2] } });
    }
    const auto & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    triangles->triangles.push_back(
      { { { n, n + 1, n + 2 } },
        { { 10 * cells[0], cells[1] == tissue::ExteriorVertex ? exterior : 10 * cells[1] } } });
  }
  return triangles;
}

/** With voxels of 0.5 x 2 x 1, in a space turned by a right angle. */
ImageType::Pointer
MakeImage(int exterior = 0)
{
  const auto               image = tissue_test::MakeFourCubes<short>(exterior);
  const double             spacing[] = { 0.5, 2.0, 1.0 };
  const double             origin[] = { 3.0, -7.0, 11.0 };
  ImageType::DirectionType direction;
  direction.SetIdentity();
  direction[0][0] = direction[1][1] = 0.0;
  direction[0][1] = -1.0;
  direction[1][0] = 1.0;
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  image->SetDirection(direction);
  return image;
}

CalculatorType::Pointer
MakeCalculator(const ImageType * image, const CalculatorType::TrianglesType & triangles)
{
  const auto calculator = CalculatorType::New();
  calculator->SetImage(image);
  calculator->SetTriangles(triangles);
  return calculator;
}

void
ExpectError(CalculatorType * calculator, const std::string & part)
{
  try
  {
    calculator->Compute();
    ADD_FAILURE() << "no error with " << part;
  }
  catch (const itk::ExceptionObject & error)
  {
    EXPECT_NE(std::string(error.GetDescription()).find(part), std::string::npos) << error.GetDescription();
  }
  EXPECT_THROW(calculator->GetEvaluation(), itk::ExceptionObject);
}
} // namespace

TEST(CellWallMeshEvaluationCalculator, FindsWhatIsKnownOfFourCubes)
{
  for (const int exterior : { 0, 7 })
  {
    const auto image = MakeImage(exterior);
    const auto calculator = MakeCalculator(image, MakeTriangles(image, exterior));
    calculator->Compute();
    const tissue::TissueMeshEvaluation & found = calculator->GetEvaluation();
    EXPECT_EQ(found.mesh.numberOfCells, 4u);
    EXPECT_EQ(found.mesh.numberOfTriangles, 40u);
    EXPECT_EQ(found.mesh.numberOfSpheres, 4u);
    EXPECT_EQ(found.mesh.numberOfCorners, 2u);
    EXPECT_EQ(found.mesh.numberOfCrowdedCorners, 2u);
    EXPECT_EQ(found.mesh.numberOfCrossings, 0u);
    EXPECT_NEAR(found.mesh.meanVolumeError, 0.0, 1e-12);
    EXPECT_NEAR(found.mesh.meanConvexity, 1.0, 1e-12);
    EXPECT_DOUBLE_EQ(found.mesh.overlap.adjacency2, 1.0);
    EXPECT_DOUBLE_EQ(found.mesh.overlap.adjacency4, 1.0);
    // Each four cells at an end of the edge have two that share the edge alone.
    EXPECT_DOUBLE_EQ(calculator->GetAdjacency4OfNeighbors(), 0.0);
    EXPECT_EQ(calculator->GetNumberOfFalsePairs(), 0u);
    EXPECT_EQ(calculator->GetNumberOfMissingPairs(), 0u);
    EXPECT_EQ(calculator->GetNumberOfPairsWithSeparateWalls(), 0u);
    EXPECT_EQ(calculator->GetNumberOfKeptPairsWithSeparateWalls(), 0u);
    EXPECT_EQ(calculator->GetGenusOfExterior(), 0);
    EXPECT_EQ(calculator->GetGenusOfExteriorInImage(), 0);
    EXPECT_EQ(calculator->GetNumberOfCellsOfSpheres(), 4u);
    EXPECT_EQ(found.distance.shareOfFalseWalls, 0.0);
    EXPECT_DOUBLE_EQ(found.meanDice, 1.0);
    EXPECT_EQ(calculator->GetCells()[4].label, 40);
  }
}

TEST(CellWallMeshEvaluationCalculator, FindsTheFaultsOfAMesh)
{
  const auto image = MakeImage();
  const auto triangles = MakeTriangles(image);
  const auto hole = std::make_shared<tissue::TrianglesOfLabels>(*triangles);
  hole->triangles.pop_back();
  auto calculator = MakeCalculator(image, hole);
  calculator->Compute();
  EXPECT_EQ(calculator->GetEvaluation().mesh.numberOfClosedCells, 3u);
  EXPECT_EQ(calculator->GetEvaluation().mesh.cells[1].eulerCharacteristic, 2);
  EXPECT_EQ(calculator->GetEvaluation().mesh.cells[4].eulerCharacteristic, 1);

  // Moved by a voxel along the first axis of the image: one of the four layers of each cube.
  const auto moved = std::make_shared<tissue::TrianglesOfLabels>(*triangles);
  for (auto & point : moved->points)
  {
    point[1] += 0.5;
  }
  calculator = MakeCalculator(image, moved);
  calculator->Compute();
  EXPECT_DOUBLE_EQ(calculator->GetEvaluation().meanDice, 0.75);
  EXPECT_GE(calculator->GetEvaluation().distance.mean, 0.1);

  const auto twice = std::make_shared<tissue::TrianglesOfLabels>(*triangles);
  twice->triangles.push_back(twice->triangles.front());
  calculator = MakeCalculator(image, twice);
  calculator->Compute();
  EXPECT_EQ(calculator->GetEvaluation().mesh.numberOfCrossings, 1u);
}

TEST(CellWallMeshEvaluationCalculator, RefusesWhatItCannotJudge)
{
  const auto image = MakeImage();
  const auto triangles = MakeTriangles(image);
  ExpectError(MakeCalculator(nullptr, triangles), "image");
  ExpectError(MakeCalculator(image, nullptr), "mesh");
  const auto calculator = MakeCalculator(image, triangles);
  calculator->SetJunctions(itk::TissueJunctions::New());
  ExpectError(calculator, "label volume");
  calculator->SetJunctions(nullptr);
  calculator->SetLabelVolume(itk::TissueLabelVolume::New());
  ExpectError(calculator, "junctions");
  EXPECT_THROW(CalculatorType::New()->SetMesh(itk::CellWallMesh::New()), itk::ExceptionObject);

  const auto foreign = std::make_shared<tissue::TrianglesOfLabels>(*triangles);
  foreign->triangles[5].labels[0] = 11;
  ExpectError(MakeCalculator(image, foreign), "triangle 5 has label 11");
  foreign->triangles[5].labels = { { 10, 10 } };
  ExpectError(MakeCalculator(image, foreign), "both sides");
  foreign->triangles[5].labels = { { 10, 0 } };
  foreign->points[4][1] = std::nan("");
  ExpectError(MakeCalculator(image, foreign), "point 4");
}

TEST(CellWallMeshEvaluationCalculator, OfAMeshOfThisModuleAgreesWithIt)
{
  const auto image = MakeSyntheticTestTissue<short>();
  const auto filter = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
  filter->SetInput(image);
  filter->Update();
  const auto extraction = itk::LabelJunctionExtractionFilter<ImageType>::New();
  extraction->SetInput(image);
  extraction->GenerateLabelVolumeOn();
  extraction->Update();
  const auto calculator = CalculatorType::New();
  calculator->SetMesh(filter->GetOutput());
  for (const bool isExtracted : { false, true })
  {
    calculator->SetImage(isExtracted ? nullptr : image.GetPointer());
    calculator->SetJunctions(isExtracted ? extraction->GetOutput() : nullptr);
    calculator->SetLabelVolume(isExtracted ? extraction->GetLabelVolume() : nullptr);
    calculator->Compute();
    const auto & found = calculator->GetEvaluation();
    EXPECT_EQ(found.mesh.numberOfSpheres, 40u);
    EXPECT_EQ(found.mesh.numberOfTriangles, filter->GetOutput()->GetNumberOfTriangles());
    EXPECT_DOUBLE_EQ(found.mesh.overlap.adjacency2, filter->GetOutput()->GetAdjacency2());
    EXPECT_DOUBLE_EQ(found.mesh.overlap.adjacency4, filter->GetOutput()->GetAdjacency4());
    EXPECT_EQ(found.mesh.numberOfCrossings, 0u);
    EXPECT_LT(found.distance.InVoxels(found.distance.mean), 0.7);
    EXPECT_GT(found.meanDice, 0.9);
  }
}
