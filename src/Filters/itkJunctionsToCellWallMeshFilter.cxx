/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkJunctionsToCellWallMeshFilter.h"

#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkCoreExecution.h"
#include "itkTissueJunctions.h"

namespace itk
{
JunctionsToCellWallMeshFilter::JunctionsToCellWallMeshFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->AddOptionalInputName("LabelVolume", 1);
}

void
JunctionsToCellWallMeshFilter::SetInput(const TissueJunctions * junctions)
{
  this->SetNthInput(0, const_cast<TissueJunctions *>(junctions));
}

const TissueJunctions *
JunctionsToCellWallMeshFilter::GetInput() const
{
  return itkDynamicCastInDebugMode<const TissueJunctions *>(this->GetPrimaryInput());
}

void
JunctionsToCellWallMeshFilter::GenerateData()
{
  const auto & parameters = this->GetParameters();
  const bool   needsVolume = parameters.fitToImage || parameters.source == tissue::ComplexSource::Image;
  const TissueLabelVolume * const   labels = needsVolume ? this->GetLabelVolume() : nullptr;
  const tissue::LabelVolume * const volume = labels != nullptr ? &labels->GetLabelVolume() : nullptr;
  const tissue::Execution           execution =
    MakeExecution(this, 0.0f, 1.0f, [this](const char * phase) { this->EnterPhase(phase); });
  const auto junctions = std::make_shared<const tissue::JunctionSet>(this->GetInput()->GetJunctionSet());
  const auto reconstruction = std::make_shared<const tissue::TissueReconstruction>(
    RunCore(this, [&] { return tissue::ReconstructTissue(*junctions, this->GetParameters(), volume, execution); }));
  this->GetOutput()->SetReconstruction(junctions, reconstruction);
}
} // namespace itk
