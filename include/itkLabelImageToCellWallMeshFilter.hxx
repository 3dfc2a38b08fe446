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
#include "itkLabelImageToLabelVolume.h"
#include "itkLabelJunctionExtractionFilter.h"
#include "itkProgressAccumulator.h"

namespace itk
{
template <typename TLabelImage>
LabelImageToCellWallMeshFilter<TLabelImage>::LabelImageToCellWallMeshFilter()
{
  this->SetNumberOfRequiredInputs(1);
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
LabelImageToCellWallMeshFilter<TLabelImage>::SetExteriorLabel(tissue::Label label)
{
  if (m_ExteriorLabel != label || m_AutomaticExteriorLabel)
  {
    m_ExteriorLabel = label;
    m_AutomaticExteriorLabel = false;
    this->Modified();
  }
}

template <typename TLabelImage>
void
LabelImageToCellWallMeshFilter<TLabelImage>::GenerateData()
{
  const auto progress = ProgressAccumulator::New();
  progress->SetMiniPipelineFilter(this);

  const auto extraction = LabelJunctionExtractionFilter<LabelImageType>::New();
  extraction->SetInput(this->GetInput());
  if (m_AutomaticExteriorLabel)
  {
    extraction->AutomaticExteriorLabelOn();
  }
  else
  {
    extraction->SetExteriorLabel(m_ExteriorLabel);
  }
  extraction->SetZeroIsCell(m_ZeroIsCell);
  extraction->SetSeparateVoids(this->GetParameters().separateVoids);
  extraction->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  progress->RegisterInternalFilter(extraction, 0.3f);

  const auto reconstruction = JunctionsToCellWallMeshFilter::New();
  reconstruction->SetInput(extraction->GetOutput());
  reconstruction->SetParameters(this->GetParameters());
  reconstruction->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  progress->RegisterInternalFilter(reconstruction, 0.7f);

  extraction->Update();
  if (this->GetParameters().fitToImage)
  {
    reconstruction->SetLabelVolume(MakeLabelVolume(this->GetInput(), extraction->GetOutput()->GetJunctionSet()));
  }
  reconstruction->Update();
  this->GetOutput()->Graft(reconstruction->GetOutput());
}

template <typename TLabelImage>
void
LabelImageToCellWallMeshFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabel: " << m_ExteriorLabel << std::endl;
  os << indent << "AutomaticExteriorLabel: " << (m_AutomaticExteriorLabel ? "On" : "Off") << std::endl;
  os << indent << "ZeroIsCell: " << (m_ZeroIsCell ? "On" : "Off") << std::endl;
}
} // namespace itk

#endif
