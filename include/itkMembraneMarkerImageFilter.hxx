/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMembraneMarkerImageFilter_hxx
#define itkMembraneMarkerImageFilter_hxx

#include "itkMembraneMarkerImageFilter.h"

#include "itkBinaryThresholdImageFilter.h"
#include "itkConnectedComponentImageFilter.h"
#include "itkHMinimaImageFilter.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIterator.h"
#include "itkMorphologicalWatershedFromMarkersImageFilter.h"
#include "itkOtsuThresholdImageFilter.h"
#include "itkRegionalMinimaImageFilter.h"
#include "itkSignedMaurerDistanceMapImageFilter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace itk
{
template <typename TMembraneImage>
void
MembraneMarkerImageFilter<TMembraneImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  const_cast<MembraneImageType *>(this->GetInput())->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TMembraneImage>
void
MembraneMarkerImageFilter<TMembraneImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TMembraneImage>
auto
MembraneMarkerImageFilter<TMembraneImage>::FindMinima(const LevelImageType * levels) const ->
  typename MarkerImageType::Pointer
{
  const auto fill = HMinimaImageFilter<LevelImageType, LevelImageType>::New();
  fill->SetInput(levels);
  fill->SetHeight(static_cast<LevelImageType::PixelType>(std::max(1.0, std::round(m_MinimumDepth * 65535.0))));
  const auto minima = RegionalMinimaImageFilter<LevelImageType, MaskImageType>::New();
  minima->SetInput(fill->GetOutput());
  minima->SetFullyConnected(true);
  minima->SetFlatIsMinima(false);
  minima->SetForegroundValue(1);
  minima->SetBackgroundValue(0);
  const auto connect = ConnectedComponentImageFilter<MaskImageType, MarkerImageType>::New();
  connect->SetInput(minima->GetOutput());
  connect->SetFullyConnected(true);
  connect->Update();
  return connect->GetOutput();
}

template <typename TMembraneImage>
double
MembraneMarkerImageFilter<TMembraneImage>::EstimateCellDiameter(const LevelImageType *  levels,
                                                                const MarkerImageType * minima) const
{
  const auto flood = MorphologicalWatershedFromMarkersImageFilter<LevelImageType, MarkerImageType>::New();
  flood->SetInput(levels);
  flood->SetMarkerImage(minima);
  flood->SetMarkWatershedLine(false);
  flood->Update();
  std::vector<SizeValueType> sizes;
  for (ImageRegionConstIterator<MarkerImageType> it(flood->GetOutput(), minima->GetLargestPossibleRegion());
       !it.IsAtEnd();
       ++it)
  {
    sizes.resize(std::max<std::size_t>(sizes.size(), it.Get() + 1));
    ++sizes[it.Get()];
  }
  // The first size is that of the voxels that no basin reaches, of which there are none if there is a basin.
  if (sizes.size() < 2)
  {
    return 0.0;
  }
  const auto median = sizes.begin() + static_cast<std::ptrdiff_t>(1 + (sizes.size() - 1) / 2);
  std::nth_element(sizes.begin() + 1, median, sizes.end());
  const auto   spacing = levels->GetSpacing();
  const double volume = static_cast<double>(*median) * spacing[0] * spacing[1] * spacing[2];
  return std::cbrt(6.0 * volume / Math::pi);
}

template <typename TMembraneImage>
auto
MembraneMarkerImageFilter<TMembraneImage>::ComputeDistance(const MaskImageType * mask) const ->
  typename DistanceImageType::Pointer
{
  const auto distance = SignedMaurerDistanceMapImageFilter<MaskImageType, DistanceImageType>::New();
  distance->SetInput(mask);
  distance->SetSquaredDistance(false);
  distance->SetUseImageSpacing(true);
  distance->Update();
  return distance->GetOutput();
}

template <typename TMembraneImage>
auto
MembraneMarkerImageFilter<TMembraneImage>::ComputeDistanceToEmptiness(const LevelImageType * levels,
                                                                      double                 radius) const ->
  typename DistanceImageType::Pointer
{
  const auto bright = OtsuThresholdImageFilter<LevelImageType, MaskImageType>::New();
  bright->SetInput(levels);
  bright->SetInsideValue(0);
  bright->SetOutsideValue(1);
  bright->SetNumberOfHistogramBins(256);
  bright->Update();
  const auto deep = BinaryThresholdImageFilter<DistanceImageType, MaskImageType>::New();
  deep->SetInput(this->ComputeDistance(bright->GetOutput()));
  deep->SetLowerThreshold(static_cast<float>(radius));
  deep->SetInsideValue(1);
  deep->SetOutsideValue(0);
  deep->Update();
  return this->ComputeDistance(deep->GetOutput());
}

template <typename TMembraneImage>
void
MembraneMarkerImageFilter<TMembraneImage>::WriteMarkers(const MarkerImageType *   minima,
                                                        const DistanceImageType * toEmptiness, double radius,
                                                        double margin)
{
  // A minimum is a cell's if one of its voxels is far enough from emptiness. A second pass numbers these by their first
  // voxels, and marks as exterior what is nearer to emptiness than the radius less the margin.
  MarkerImageType * const output = this->GetOutput();
  const auto              region = output->GetLargestPossibleRegion();

  ImageRegionConstIterator<MarkerImageType>   minimum(minima, region);
  ImageRegionConstIterator<DistanceImageType> distance(toEmptiness, region);
  std::vector<char>                           isCell;
  for (; !minimum.IsAtEnd(); ++minimum, ++distance)
  {
    isCell.resize(std::max<std::size_t>(isCell.size(), minimum.Get() + 1), 0);
    isCell[minimum.Get()] = isCell[minimum.Get()] || (minimum.Get() > 0 && distance.Get() >= radius);
  }
  std::vector<std::uint32_t> numbers(isCell.size(), 0);
  m_NumberOfCells = 0;
  m_HasExterior = false;
  minimum.GoToBegin();
  distance.GoToBegin();
  for (ImageRegionIterator<MarkerImageType> it(output, region); !it.IsAtEnd(); ++it, ++minimum, ++distance)
  {
    const std::uint32_t m = minimum.Get();
    if (isCell[m] && numbers[m] == 0)
    {
      numbers[m] = static_cast<std::uint32_t>(++m_NumberOfCells + 1);
    }
    const bool isExterior = !isCell[m] && distance.Get() < radius - margin;
    it.Set(isExterior ? 1 : numbers[m]);
    m_HasExterior = m_HasExterior || isExterior;
  }
}

template <typename TMembraneImage>
void
MembraneMarkerImageFilter<TMembraneImage>::GenerateData()
{
  this->AllocateOutputs();
  const MembraneImageType * input = this->GetInput();
  RequireVaryingFinitePixels(input);
  const auto                        spacing = input->GetSpacing();
  const double                      sigma = m_Sigma > 0.0 ? m_Sigma : std::cbrt(spacing[0] * spacing[1] * spacing[2]);
  const LevelImageType::Pointer     levels = MakeSmoothedLevels(input, sigma, this->GetNumberOfWorkUnits());
  typename MarkerImageType::Pointer minima = this->FindMinima(levels);
  this->UpdateProgress(0.4f);
  const double cellDiameter = this->EstimateCellDiameter(levels, minima);
  this->UpdateProgress(0.7f);
  this->WriteMarkers(
    minima, this->ComputeDistanceToEmptiness(levels, cellDiameter), cellDiameter, m_ExteriorMargin * cellDiameter);
}

template <typename TMembraneImage>
void
MembraneMarkerImageFilter<TMembraneImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Sigma: " << m_Sigma << std::endl;
  os << indent << "MinimumDepth: " << m_MinimumDepth << std::endl;
  os << indent << "ExteriorMargin: " << m_ExteriorMargin << std::endl;
  os << indent << "NumberOfCells: " << m_NumberOfCells << std::endl;
  os << indent << "HasExterior: " << (m_HasExterior ? "On" : "Off") << std::endl;
}
} // namespace itk

#endif
