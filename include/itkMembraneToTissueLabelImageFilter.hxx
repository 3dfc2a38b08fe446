/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMembraneToTissueLabelImageFilter_hxx
#define itkMembraneToTissueLabelImageFilter_hxx

#include "itkMembraneToTissueLabelImageFilter.h"

#include "itkCellCoreImageFilter.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIterator.h"
#include "itkMembraneMarkerImageFilter.h"
#include "itkMorphologicalWatershedFromMarkersImageFilter.h"
#include "itkNearestNeighborInterpolateImageFunction.h"
#include "itkProgressAccumulator.h"
#include "itkResampleImageFilter.h"
#include "itkSmoothedLevels.h"

#include <algorithm>
#include <set>

namespace itk
{
template <typename TMembraneImage, typename TLabelImage>
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::MembraneToTissueLabelImageFilter()
{
  this->AddOptionalInputName("CellImage", 1);
}

template <typename TMembraneImage, typename TLabelImage>
void
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::SetCellImage(const LabelImageType * cells)
{
  this->SetInput("CellImage", const_cast<LabelImageType *>(cells));
}

template <typename TMembraneImage, typename TLabelImage>
auto
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::GetCellImage() const -> const LabelImageType *
{
  return itkDynamicCastInDebugMode<const LabelImageType *>(this->ProcessObject::GetInput("CellImage"));
}

template <typename TMembraneImage, typename TLabelImage>
void
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::GenerateInputRequestedRegion()
{
  for (const auto & name : this->GetInputNames())
  {
    if (DataObject * const input = this->ProcessObject::GetInput(name))
    {
      input->SetRequestedRegionToLargestPossibleRegion();
    }
  }
}

template <typename TMembraneImage, typename TLabelImage>
void
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TMembraneImage, typename TLabelImage>
auto
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::ResampleCells() -> typename LabelImageType::Pointer
{
  // Labels that are in the cell image but not in its resampled copy belong to cells that would be lost.
  const LabelImageType * cells = this->GetCellImage();
  const auto             resample = ResampleImageFilter<LabelImageType, LabelImageType>::New();
  resample->SetInput(cells);
  resample->SetInterpolator(NearestNeighborInterpolateImageFunction<LabelImageType>::New());
  resample->SetOutputParametersFromImage(this->GetInput());
  resample->SetDefaultPixelValue(m_ExteriorLabel);
  resample->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  resample->Update();

  const auto findLabels = [this](const LabelImageType * image) {
    std::set<LabelPixelType> labels{ m_ExteriorLabel };
    LabelPixelType           last = m_ExteriorLabel;
    for (ImageRegionConstIterator<LabelImageType> it(image, image->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
    {
      if (it.Get() != last)
      {
        last = it.Get();
        labels.insert(last);
      }
    }
    return labels;
  };
  const auto                  wanted = findLabels(cells);
  const auto                  found = findLabels(resample->GetOutput());
  std::vector<LabelPixelType> lost;
  std::set_difference(wanted.begin(), wanted.end(), found.begin(), found.end(), std::back_inserter(lost));
  if (!lost.empty())
  {
    itkExceptionMacro(<< lost.size() << " of " << wanted.size() - 1 << " cells have no voxel in the membrane image, "
                      << "label " << static_cast<typename NumericTraits<LabelPixelType>::PrintType>(lost.front())
                      << " for one: they are smaller than its voxels or outside of it");
  }
  return resample->GetOutput();
}

template <typename TMembraneImage, typename TLabelImage>
auto
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::MarkCores(std::vector<LabelPixelType> & labels) ->
  typename MarkerImageType::Pointer
{
  const auto cores = CellCoreImageFilter<LabelImageType>::New();
  cores->SetInput(this->ResampleCells());
  cores->SetExteriorLabel(m_ExteriorLabel);
  cores->SetCoreDepth(m_CoreDepth);
  cores->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  cores->Update();
  for (const tissue::Label label : cores->GetLabels())
  {
    labels.push_back(static_cast<LabelPixelType>(label));
  }
  return cores->GetOutput();
}

template <typename TMembraneImage, typename TLabelImage>
auto
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::MarkMinima(std::vector<LabelPixelType> & labels) ->
  typename MarkerImageType::Pointer
{
  const auto minima = MembraneMarkerImageFilter<MembraneImageType>::New();
  minima->SetInput(this->GetInput());
  minima->SetSigma(m_MarkerSigma);
  minima->SetMinimumDepth(m_MinimumDepth);
  minima->SetNoiseDepth(m_NoiseDepth);
  minima->SetDarkMembranes(m_DarkMembranes);
  minima->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  minima->Update();
  m_Noise = minima->GetNoise();
  m_UsedDepth = minima->GetUsedDepth();
  const SizeValueType most = static_cast<SizeValueType>(NumericTraits<LabelPixelType>::max());
  if (minima->GetNumberOfCells() >= most)
  {
    itkExceptionMacro(<< minima->GetNumberOfCells() << " cells are more than the label image's pixels can number, "
                      << most - 1);
  }
  for (LabelPixelType label = 1; labels.size() < minima->GetNumberOfCells() + 2; ++label)
  {
    if (label != m_ExteriorLabel)
    {
      labels.push_back(label);
    }
  }
  return minima->GetOutput();
}

template <typename TMembraneImage, typename TLabelImage>
auto
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::MakeMarkers(std::vector<LabelPixelType> & labels) ->
  typename MarkerImageType::Pointer
{
  labels.assign(2, m_ExteriorLabel);
  m_Noise = 0.0;
  m_UsedDepth = 0.0;
  return this->GetCellImage() != nullptr ? this->MarkCores(labels) : this->MarkMinima(labels);
}

template <typename TMembraneImage, typename TLabelImage>
void
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::GenerateData()
{
  constexpr float markerShare = 0.3f; // The markers have this part of the progress.

  const MembraneImageType * input = this->GetInput();
  RequireVaryingFinitePixels(input);
  std::vector<LabelPixelType>             labels;
  const typename MarkerImageType::Pointer markers = this->MakeMarkers(labels);
  m_NumberOfCells = labels.size() - 2;
  this->UpdateProgress(markerShare);

  const auto flood = MorphologicalWatershedFromMarkersImageFilter<LevelImageType, MarkerImageType>::New();
  flood->SetInput(MakeSmoothedLevels(input, m_Sigma, m_DarkMembranes, this->GetNumberOfWorkUnits()).image);
  flood->SetMarkerImage(markers);
  flood->SetMarkWatershedLine(false);
  const auto progress = ProgressAccumulator::New();
  progress->SetMiniPipelineFilter(this);
  progress->RegisterInternalFilter(flood, 1.0f - markerShare);
  flood->Update();

  this->AllocateOutputs();
  const auto                                region = this->GetOutput()->GetLargestPossibleRegion();
  ImageRegionConstIterator<MarkerImageType> basin(flood->GetOutput(), region);
  for (ImageRegionIterator<LabelImageType> it(this->GetOutput(), region); !it.IsAtEnd(); ++it, ++basin)
  {
    it.Set(labels[basin.Get()]);
  }
}

template <typename TMembraneImage, typename TLabelImage>
void
MembraneToTissueLabelImageFilter<TMembraneImage, TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using PrintType = typename NumericTraits<LabelPixelType>::PrintType;
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabel: " << static_cast<PrintType>(m_ExteriorLabel) << std::endl;
  os << indent << "DarkMembranes: " << (m_DarkMembranes ? "On" : "Off") << std::endl;
  os << indent << "Sigma: " << m_Sigma << std::endl;
  os << indent << "CoreDepth: " << m_CoreDepth << std::endl;
  os << indent << "MarkerSigma: " << m_MarkerSigma << std::endl;
  os << indent << "MinimumDepth: " << m_MinimumDepth << std::endl;
  os << indent << "NoiseDepth: " << m_NoiseDepth << std::endl;
  os << indent << "Noise: " << m_Noise << std::endl;
  os << indent << "UsedDepth: " << m_UsedDepth << std::endl;
  os << indent << "NumberOfCells: " << m_NumberOfCells << std::endl;
}
} // namespace itk

#endif
