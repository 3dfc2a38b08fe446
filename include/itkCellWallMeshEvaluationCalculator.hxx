/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellWallMeshEvaluationCalculator_hxx
#define itkCellWallMeshEvaluationCalculator_hxx

#include "itkCellWallMeshEvaluationCalculator.h"

#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkCoreExecution.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <stdexcept>

namespace itk
{
template <typename TLabelImage>
CellWallMeshEvaluationCalculator<TLabelImage>::CellWallMeshEvaluationCalculator()
  : m_MultiThreader(MultiThreaderBase::New())
{}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::SetMesh(const CellWallMesh * mesh)
{
  const tissue::WallMesh & walls = mesh->GetWallMesh();
  const auto &             cells = mesh->GetJunctionSet().cells;
  const auto               triangles = std::make_shared<tissue::TrianglesOfLabels>();
  triangles->points = walls.points;
  for (SizeValueType t = 0; t < walls.triangles.size(); ++t)
  {
    const auto & [first, second] = walls.walls[walls.wallOfTriangle[t]].cells;
    triangles->triangles.push_back({ walls.triangles[t], { { cells[first].label, cells[second].label } } });
  }
  this->SetTriangles(triangles);
}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::SetTriangles(TrianglesType triangles)
{
  m_Triangles = std::move(triangles);
  this->Modified();
}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::SetNumberOfWorkUnits(ThreadIdType number)
{
  m_MultiThreader->SetNumberOfWorkUnits(number);
}

template <typename TLabelImage>
ThreadIdType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfWorkUnits() const
{
  return m_MultiThreader->GetNumberOfWorkUnits();
}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::CheckInputs() const
{
  if (!m_Triangles)
  {
    itkExceptionMacro("The mesh is not set.");
  }
  if (m_Junctions.IsNull() != m_LabelVolume.IsNull())
  {
    itkExceptionMacro("The " << (m_Junctions ? "label volume" : "junctions") << " of the image must be set, too.");
  }
  if (!m_Junctions && !m_Image)
  {
    itkExceptionMacro("The image is not set.");
  }
}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::Compute()
{
  m_Evaluation.reset();
  this->CheckInputs();
  if (m_Junctions)
  {
    this->Evaluate(m_Junctions->GetJunctionSet(), m_LabelVolume->GetLabelVolume());
    return;
  }
  const auto extraction = LabelJunctionExtractionFilter<LabelImageType>::New();
  extraction->SetInput(m_Image);
  extraction->SetExterior(m_Exterior);
  extraction->GenerateLabelVolumeOn();
  extraction->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  extraction->Update();
  this->Evaluate(extraction->GetOutput()->GetJunctionSet(), extraction->GetLabelVolume()->GetLabelVolume());
}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::Evaluate(const tissue::JunctionSet & junctions,
                                                        const tissue::LabelVolume & labels)
{
  m_Evaluation = RunCore(this, [&] {
    const auto walls = tissue::MakeWallMesh(tissue::FindCellsOfTriangles(*m_Triangles, junctions));
    return std::make_unique<const tissue::TissueMeshEvaluation>(
      tissue::EvaluateTissueMesh(walls, junctions, labels, MakeExecution(m_MultiThreader)));
  });
  m_Cells = junctions.cells;
}

template <typename TLabelImage>
const tissue::TissueMeshEvaluation &
CellWallMeshEvaluationCalculator<TLabelImage>::GetEvaluation() const
{
  if (!m_Evaluation)
  {
    itkExceptionMacro("There is no evaluation before Compute().");
  }
  return *m_Evaluation;
}

template <typename TLabelImage>
const std::vector<tissue::Cell> &
CellWallMeshEvaluationCalculator<TLabelImage>::GetCells() const
{
  this->GetEvaluation();
  return m_Cells;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetAdjacency2() const
{
  return this->GetEvaluation().mesh.overlap.adjacency2;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetAdjacency4() const
{
  return this->GetEvaluation().mesh.overlap.adjacency4;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetAdjacency4OfNeighbors() const
{
  return this->GetEvaluation().mesh.overlap.adjacency4OfNeighbors;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfFalsePairs() const
{
  return this->GetEvaluation().mesh.overlap.numberOfFalsePairs;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfMissingPairs() const
{
  return this->GetEvaluation().mesh.overlap.numberOfMissingPairs;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfPairsWithSeparateWalls() const
{
  return this->GetEvaluation().separateWalls.numberOfPairs;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfKeptPairsWithSeparateWalls() const
{
  return this->GetEvaluation().separateWalls.numberOfKeptPairs;
}

template <typename TLabelImage>
OffsetValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetGenusOfExterior() const
{
  return this->GetEvaluation().exteriorOfMesh.Genus();
}

template <typename TLabelImage>
OffsetValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetGenusOfExteriorInImage() const
{
  return this->GetEvaluation().exteriorOfImage.Genus();
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfCells() const
{
  return this->GetEvaluation().mesh.numberOfCells;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfClosedCells() const
{
  return this->GetEvaluation().mesh.numberOfClosedCells;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfCellsOfSpheres() const
{
  return this->GetEvaluation().mesh.numberOfCellsOfSpheres;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfCrowdedCorners() const
{
  return this->GetEvaluation().mesh.numberOfCrowdedCorners;
}

template <typename TLabelImage>
SizeValueType
CellWallMeshEvaluationCalculator<TLabelImage>::GetNumberOfCrossings() const
{
  return this->GetEvaluation().mesh.numberOfCrossings;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMeanVolumeError() const
{
  return this->GetEvaluation().mesh.meanVolumeError;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMeanWallDistance() const
{
  return this->GetEvaluation().distance.mean;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMeanWallDistanceFromImage() const
{
  return this->GetEvaluation().distance.meanFromImage;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetHausdorffDistance95() const
{
  return this->GetEvaluation().distance.percentile95;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMeanTriangleQuality() const
{
  return this->GetEvaluation().mesh.quality.mean;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMinimumTriangleAngle() const
{
  return this->GetEvaluation().mesh.angles.minimumTriangleAngle;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMinimumDihedralAngle() const
{
  return this->GetEvaluation().mesh.angles.minimumDihedralAngle;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetEdgeLengthRatio() const
{
  return this->GetEvaluation().mesh.angles.EdgeLengthRatio();
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMeanDice() const
{
  return this->GetEvaluation().meanDice;
}

template <typename TLabelImage>
double
CellWallMeshEvaluationCalculator<TLabelImage>::GetMeanConvexity() const
{
  return this->GetEvaluation().mesh.meanConvexity;
}

template <typename TLabelImage>
void
CellWallMeshEvaluationCalculator<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Image);
  os << indent << "Triangles: " << (m_Triangles ? m_Triangles->triangles.size() : 0) << std::endl;
  itkPrintSelfObjectMacro(Junctions);
  itkPrintSelfObjectMacro(LabelVolume);
  itkPrintSelfObjectMacro(MultiThreader);
  m_Exterior.Print(os, indent);
  os << indent << "Evaluation: " << (m_Evaluation ? "computed" : "none") << std::endl;
}
} // namespace itk

#endif
