/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMembraneMarkerImageFilter_hxx
#define itkMembraneMarkerImageFilter_hxx

#include "itkMembraneMarkerImageFilter.h"

#include "TissueTessellationCore/Points/BlobNoise.h"
#include "itkBinaryThresholdImageFilter.h"
#include "itkConnectedComponentImageFilter.h"
#include "itkHMinimaImageFilter.h"
#include "itkImageNoiseCalculator.h"
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
void
MembraneMarkerImageFilter<TMembraneImage>::ChooseDepth(const SmoothedLevels & levels, double sigma)
{
  const auto calculator = ImageNoiseCalculator<MembraneImageType>::New();
  calculator->SetImage(this->GetInput());
  calculator->Compute();
  m_Noise = calculator->GetDeviation();
  const auto   spacing = this->GetInput()->GetSpacing();
  const double left = m_Noise * tissue::SmoothedNoise(sigma, { { spacing[0], spacing[1], spacing[2] } });
  m_UsedDepth = std::clamp(m_NoiseDepth * left * levels.levelsPerUnit / 65535.0, m_MinimumDepth, 1.0);
}

template <typename TMembraneImage>
auto
MembraneMarkerImageFilter<TMembraneImage>::FindMinima(const LevelImageType * levels) const ->
  typename MarkerImageType::Pointer
{
  const auto fill = HMinimaImageFilter<LevelImageType, LevelImageType>::New();
  fill->SetInput(levels);
  fill->SetHeight(static_cast<LevelImageType::PixelType>(std::max(1.0, std::round(m_UsedDepth * 65535.0))));
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
std::vector<char>
MembraneMarkerImageFilter<TMembraneImage>::FindCells(const MarkerImageType *   minima,
                                                     const DistanceImageType * toEmptiness, double radius,
                                                     double margin) const
{
  struct Minimum
  {
    SizeValueType numberOfVoxels = 0;
    bool          isBeyond = false;
    bool          isExterior = false;
  };
  const auto                                  region = minima->GetLargestPossibleRegion();
  ImageRegionConstIterator<MarkerImageType>   minimum(minima, region);
  ImageRegionConstIterator<DistanceImageType> distance(toEmptiness, region);
  std::vector<Minimum>                        found;
  for (; !minimum.IsAtEnd(); ++minimum, ++distance)
  {
    found.resize(std::max<std::size_t>(found.size(), minimum.Get() + 1));
    Minimum & current = found[minimum.Get()];
    ++current.numberOfVoxels;
    current.isBeyond = current.isBeyond || distance.Get() >= radius;
    current.isExterior = current.isExterior || distance.Get() < radius - margin;
  }
  const auto        spacing = minima->GetSpacing();
  constexpr double  largest = 2.0; // Cells of a tissue may differ that much.
  const double      cell = Math::pi / 6.0 * std::pow(radius, 3) / (spacing[0] * spacing[1] * spacing[2]);
  std::vector<char> isCell(found.size(), 0);
  for (std::size_t m = 1; m < found.size(); ++m)
  {
    const bool isLarge = static_cast<double>(found[m].numberOfVoxels) > largest * cell;
    isCell[m] = found[m].isBeyond && !(found[m].isExterior && isLarge) ? 1 : 0;
  }
  return isCell;
}

template <typename TMembraneImage>
void
MembraneMarkerImageFilter<TMembraneImage>::WriteMarkers(const MarkerImageType *   minima,
                                                        const DistanceImageType * toEmptiness, double radius,
                                                        double margin)
{
  // A second pass numbers the minima of cells by their first voxels, and marks as exterior what is nearer to emptiness
  // than the radius less the margin.
  MarkerImageType * const output = this->GetOutput();
  const auto              region = output->GetLargestPossibleRegion();
  const std::vector<char> isCell = this->FindCells(minima, toEmptiness, radius, margin);

  ImageRegionConstIterator<MarkerImageType>   minimum(minima, region);
  ImageRegionConstIterator<DistanceImageType> distance(toEmptiness, region);
  std::vector<std::uint32_t>                  numbers(isCell.size(), 0);
  m_NumberOfCells = 0;
  m_HasExterior = false;
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
  const auto           spacing = input->GetSpacing();
  const double         sigma = m_Sigma > 0.0 ? m_Sigma : std::cbrt(spacing[0] * spacing[1] * spacing[2]);
  const SmoothedLevels smoothed = MakeSmoothedLevels(input, sigma, m_DarkMembranes, this->GetNumberOfWorkUnits());
  this->ChooseDepth(smoothed, sigma);
  const LevelImageType * const            levels = smoothed.image;
  const typename MarkerImageType::Pointer minima = this->FindMinima(levels);
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
  os << indent << "DarkMembranes: " << (m_DarkMembranes ? "On" : "Off") << std::endl;
  os << indent << "Sigma: " << m_Sigma << std::endl;
  os << indent << "MinimumDepth: " << m_MinimumDepth << std::endl;
  os << indent << "NoiseDepth: " << m_NoiseDepth << std::endl;
  os << indent << "ExteriorMargin: " << m_ExteriorMargin << std::endl;
  os << indent << "Noise: " << m_Noise << std::endl;
  os << indent << "UsedDepth: " << m_UsedDepth << std::endl;
  os << indent << "NumberOfCells: " << m_NumberOfCells << std::endl;
  os << indent << "HasExterior: " << (m_HasExterior ? "On" : "Off") << std::endl;
}
} // namespace itk

#endif
