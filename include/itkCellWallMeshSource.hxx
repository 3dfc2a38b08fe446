/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellWallMeshSource_hxx
#define itkCellWallMeshSource_hxx

#include "itkCellWallMeshSource.h"

#include "TissueTessellationCore/ReconstructionParameters.h"

namespace itk
{
inline CellWallMeshSource::CellWallMeshSource()
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

inline void
CellWallMeshSource::SetParameters(const tissue::ReconstructionParameters & parameters)
{
  this->Change([&](tissue::ReconstructionParameters & p) { p = parameters; });
}

inline void
CellWallMeshSource::UseDefaultPreset()
{
  this->SetParameters(tissue::ReconstructionParameters());
}

inline void
CellWallMeshSource::UsePaperPreset()
{
  this->SetParameters(tissue::ReconstructionParameters::PaperPreset());
}

inline void
CellWallMeshSource::SetSeed(SeedType seed)
{
  this->Change([seed](tissue::ReconstructionParameters & p) { p.annealing.seed = seed; });
}

inline void
CellWallMeshSource::SetMaximumEdgeLength(double length)
{
  this->Change([length](tissue::ReconstructionParameters & p) { p.maximumEdgeLength = length; });
}

inline void
CellWallMeshSource::SetNumberOfCycles(int cycles)
{
  this->Change([cycles](tissue::ReconstructionParameters & p) { p.annealing.numberOfCycles = cycles; });
}

inline void
CellWallMeshSource::SetTrianglesPerCell(double number)
{
  this->Change([number](tissue::ReconstructionParameters & p) { p.trianglesPerCell = number; });
}

inline void
CellWallMeshSource::SetRefinement(int levels)
{
  this->Change([levels](tissue::ReconstructionParameters & p) { p.refinement = levels; });
}

inline void
CellWallMeshSource::SetSmoothingIterations(int iterations)
{
  this->Change([iterations](tissue::ReconstructionParameters & p) { p.smoothingIterations = iterations; });
}

inline CellWallMeshSource::SeedType
CellWallMeshSource::GetSeed() const
{
  return m_Parameters->annealing.seed;
}

inline double
CellWallMeshSource::GetMaximumEdgeLength() const
{
  return m_Parameters->maximumEdgeLength;
}

inline int
CellWallMeshSource::GetNumberOfCycles() const
{
  return m_Parameters->annealing.numberOfCycles;
}

inline double
CellWallMeshSource::GetTrianglesPerCell() const
{
  return m_Parameters->trianglesPerCell;
}

inline int
CellWallMeshSource::GetRefinement() const
{
  return m_Parameters->refinement;
}

inline int
CellWallMeshSource::GetSmoothingIterations() const
{
  return m_Parameters->smoothingIterations;
}

inline CellWallMesh *
CellWallMeshSource::GetOutput()
{
  return itkDynamicCastInDebugMode<CellWallMesh *>(this->GetPrimaryOutput());
}

inline const CellWallMesh *
CellWallMeshSource::GetOutput() const
{
  return itkDynamicCastInDebugMode<const CellWallMesh *>(this->GetPrimaryOutput());
}

inline CellWallMeshSource::DataObjectPointer
CellWallMeshSource::MakeOutput(DataObjectPointerArraySizeType)
{
  return CellWallMesh::New().GetPointer();
}

inline void
CellWallMeshSource::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Seed: " << m_Parameters->annealing.seed << std::endl;
  os << indent << "MaximumEdgeLength: " << m_Parameters->maximumEdgeLength << std::endl;
  os << indent << "NumberOfCycles: " << m_Parameters->annealing.numberOfCycles << std::endl;
  os << indent << "TrianglesPerCell: " << m_Parameters->trianglesPerCell << std::endl;
  os << indent << "Refinement: " << m_Parameters->refinement << std::endl;
  os << indent << "SmoothingIterations: " << m_Parameters->smoothingIterations << std::endl;
}
} // namespace itk

#endif
