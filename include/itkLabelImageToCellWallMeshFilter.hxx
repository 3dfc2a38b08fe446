/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelImageToCellWallMeshFilter_hxx
#define itkLabelImageToCellWallMeshFilter_hxx

#include "itkLabelImageToCellWallMeshFilter.h"

#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"
#include "itkJunctionsToCellWallMeshFilter.h"
#include "itkLabelJunctionExtractionFilter.h"
#include "itkProgressAccumulator.h"

namespace itk
{
template <typename TLabelImage>
LabelImageToCellWallMeshFilter<TLabelImage>::LabelImageToCellWallMeshFilter()
{
  this->SetNumberOfRequiredInputs(1);
  this->AddOptionalInputName("Votes", 1);
}

template <typename TLabelImage>
void
LabelImageToCellWallMeshFilter<TLabelImage>::SetInput(const LabelImageType * image)
{
  this->SetNthInput(0, const_cast<LabelImageType *>(image));
}

template <typename TLabelImage>
auto
LabelImageToCellWallMeshFilter<TLabelImage>::GetInput() const -> const LabelImageType *
{
  return itkDynamicCastInDebugMode<const LabelImageType *>(this->GetPrimaryInput());
}

template <typename TLabelImage>
void
LabelImageToCellWallMeshFilter<TLabelImage>::GenerateData()
{
  const auto progress = ProgressAccumulator::New();
  progress->SetMiniPipelineFilter(this);

  this->EnterPhase("Finding junctions");
  const auto extraction = LabelJunctionExtractionFilter<LabelImageType>::New();
  extraction->SetInput(this->GetInput());
  extraction->SetVotes(this->GetVotes());
  extraction->SetExterior(m_Exterior);
  extraction->GenerateLabelVolumeOn();
  extraction->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  progress->RegisterInternalFilter(extraction, 0.3f);

  const auto reconstruction = JunctionsToCellWallMeshFilter::New();
  reconstruction->SetInput(extraction->GetOutput());
  reconstruction->SetLabelVolume(extraction->GetLabelVolume());
  reconstruction->SetParameters(this->GetParameters());
  reconstruction->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  // Before the progress is told to those who ask for the phase.
  const auto takePhase = [this, mesher = reconstruction.GetPointer()](const EventObject &) {
    if (mesher->GetPhase() != std::string(this->GetPhase()))
    {
      this->EnterPhase(mesher->GetPhase());
    }
  };
  reconstruction->AddObserver(ProgressEvent(), takePhase);
  progress->RegisterInternalFilter(reconstruction, 0.7f);

  reconstruction->Update();
  this->GetOutput()->Graft(reconstruction->GetOutput());
}

template <typename TLabelImage>
void
LabelImageToCellWallMeshFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  m_Exterior.Print(os, indent);
}
} // namespace itk

#endif
