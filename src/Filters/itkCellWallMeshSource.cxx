/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkCellWallMeshSource.h"

#include "TissueTessellationCore/Reconstruction/ParameterTable.h"

#include <cctype>

namespace itk
{
CellWallMeshSource::CellWallMeshSource()
  : m_Parameters(std::make_shared<tissue::ReconstructionParameters>())
{
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

template <typename TChange>
void
CellWallMeshSource::Change(const TChange & change)
{
  auto parameters = std::make_shared<tissue::ReconstructionParameters>(*m_Parameters);
  change(*parameters);
  m_Parameters = parameters;
  this->Modified();
}

void
CellWallMeshSource::SetParameters(const tissue::ReconstructionParameters & parameters)
{
  this->Change([&](tissue::ReconstructionParameters & p) { p = parameters; });
}

void
CellWallMeshSource::UseDefaultPreset()
{
  this->SetParameters(tissue::ReconstructionParameters());
}

void
CellWallMeshSource::UsePaperPreset()
{
  this->SetParameters(tissue::ReconstructionParameters::PaperPreset());
}

void
CellWallMeshSource::SetSeed(SeedType seed)
{
  this->Change([seed](tissue::ReconstructionParameters & p) { p.annealing.seed = seed; });
}

void
CellWallMeshSource::SetMaximumEdgeLength(double length)
{
  this->Change([length](tissue::ReconstructionParameters & p) { p.maximumEdgeLength = length; });
}

void
CellWallMeshSource::SetNumberOfCycles(int cycles)
{
  this->Change([cycles](tissue::ReconstructionParameters & p) { p.annealing.numberOfCycles = cycles; });
}

void
CellWallMeshSource::SetTrianglesPerCell(double number)
{
  this->Change([number](tissue::ReconstructionParameters & p) { p.trianglesPerCell = number; });
}

void
CellWallMeshSource::SetRefinement(int levels)
{
  this->Change([levels](tissue::ReconstructionParameters & p) { p.refinement = levels; });
}

void
CellWallMeshSource::SetSmoothingIterations(int iterations)
{
  this->Change([iterations](tissue::ReconstructionParameters & p) { p.smoothingIterations = iterations; });
}

CellWallMeshSource::SeedType
CellWallMeshSource::GetSeed() const
{
  return m_Parameters->annealing.seed;
}

double
CellWallMeshSource::GetMaximumEdgeLength() const
{
  return m_Parameters->maximumEdgeLength;
}

int
CellWallMeshSource::GetNumberOfCycles() const
{
  return m_Parameters->annealing.numberOfCycles;
}

double
CellWallMeshSource::GetTrianglesPerCell() const
{
  return m_Parameters->trianglesPerCell;
}

int
CellWallMeshSource::GetRefinement() const
{
  return m_Parameters->refinement;
}

int
CellWallMeshSource::GetSmoothingIterations() const
{
  return m_Parameters->smoothingIterations;
}

void
CellWallMeshSource::EnterPhase(const std::string & phase)
{
  m_Phase = phase;
  this->UpdateProgress(this->GetProgress());
}

CellWallMesh *
CellWallMeshSource::GetOutput()
{
  return itkDynamicCastInDebugMode<CellWallMesh *>(this->GetPrimaryOutput());
}

const CellWallMesh *
CellWallMeshSource::GetOutput() const
{
  return itkDynamicCastInDebugMode<const CellWallMesh *>(this->GetPrimaryOutput());
}

CellWallMeshSource::DataObjectPointer
CellWallMeshSource::MakeOutput(DataObjectPointerArraySizeType)
{
  return CellWallMesh::New().GetPointer();
}

void
CellWallMeshSource::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Phase: " << m_Phase << std::endl;
  for (const tissue::Parameter & parameter : tissue::GetParameterTable())
  {
    // As the names of ITK's own members are printed, with a capital.
    std::string name = parameter.name;
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
    os << indent << name << ": " << tissue::ToString(tissue::GetValue(parameter, *m_Parameters)) << std::endl;
  }
}
} // namespace itk
