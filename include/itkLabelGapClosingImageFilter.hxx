/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelGapClosingImageFilter_hxx
#define itkLabelGapClosingImageFilter_hxx

#include "itkLabelGapClosingImageFilter.h"

#include "itkBinaryFillholeImageFilter.h"
#include "itkBinaryStatisticsOpeningImageFilter.h"
#include "itkBinaryThresholdImageFilter.h"
#include "itkImageAlgorithm.h"
#include "itkImageLinearConstIteratorWithIndex.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkMaximumImageFilter.h"
#include "itkMultiThreaderBase.h"
#include "itkProgressAccumulator.h"
#include "itkSignedMaurerDistanceMapImageFilter.h"
#include "itkSubtractImageFilter.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

namespace itk
{
template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  if (auto * input = const_cast<LabelImageType *>(this->GetInput()))
  {
    input->SetRequestedRegionToLargestPossibleRegion();
  }
}

template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::GenerateData()
{
  static_assert(LabelImageType::ImageDimension == 3, "A tissue is an image in three dimensions.");
  if (m_GapWidth < 0.0)
  {
    itkExceptionMacro(<< "The gap width " << m_GapWidth << " is negative");
  }
  this->AllocateOutputs();
  const LabelImageType * input = this->GetInput();
  const auto             region = input->GetLargestPossibleRegion();
  ImageAlgorithm::Copy(input, this->GetOutput(), region, region);

  m_NumberOfChangedVoxels = 0;
  m_LargestDistance = 0.0;
  m_UsedGapWidth = m_GapWidth > 0.0 ? m_GapWidth : this->EstimateGapWidth();
  if (m_UsedGapWidth > 0.0)
  {
    // Across a gap of n voxels the cells' voxels are n + 1 apart. The tolerance keeps equal distances equal.
    const auto   spacing = input->GetSpacing();
    const double reach = (m_UsedGapWidth + *std::max_element(spacing.Begin(), spacing.End())) * (1.0 + 1e-5);
    this->GrowCells(this->ComputeGapMask(0.5 * reach), reach);
  }
  this->MeasureGapsLeft();
}

template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::MeasureGapsLeft()
{
  const double        limit = this->ComputeMeanCellDiameter();
  std::vector<double> lengths;
  SizeValueType       numberOfContacts = 0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    this->CollectGapLengths(this->GetOutput(), axis, limit, lengths, numberOfContacts);
  }
  m_ShareOfGapsLeft = 0.0;
  m_WidthOfGapsLeft = 0.0;
  if (!lengths.empty())
  {
    const auto numberOfGaps = static_cast<double>(lengths.size());
    const auto wide = lengths.begin() + static_cast<std::ptrdiff_t>(0.9 * numberOfGaps);
    std::nth_element(lengths.begin(), wide, lengths.end());
    m_ShareOfGapsLeft = numberOfGaps / (numberOfGaps + static_cast<double>(numberOfContacts));
    m_WidthOfGapsLeft = *wide;
  }
}

template <typename TLabelImage>
double
LabelGapClosingImageFilter<TLabelImage>::EstimateGapWidth() const
{
  const double        limit = 0.5 * this->ComputeMeanCellDiameter();
  std::vector<double> lengths;
  SizeValueType       numberOfContacts = 0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    this->CollectGapLengths(this->GetInput(), axis, limit, lengths, numberOfContacts);
  }
  if (lengths.empty())
  {
    return 0.0;
  }
  const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), median, lengths.end());
  return 2.0 * *median;
}

template <typename TLabelImage>
double
LabelGapClosingImageFilter<TLabelImage>::ComputeMeanCellDiameter() const
{
  std::set<LabelPixelType> labels;
  SizeValueType            numberOfVoxels = 0;
  LabelPixelType           last = m_BackgroundLabel;
  const LabelImageType *   input = this->GetInput();
  for (ImageRegionConstIterator<LabelImageType> it(input, input->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    const LabelPixelType label = it.Get();
    numberOfVoxels += label != m_BackgroundLabel;
    if (label != last && label != m_BackgroundLabel)
    {
      labels.insert(label);
      last = label;
    }
  }
  const auto   spacing = input->GetSpacing();
  const double volume = static_cast<double>(numberOfVoxels) * spacing[0] * spacing[1] * spacing[2];
  return labels.empty() ? 0.0 : std::cbrt(6.0 * volume / (Math::pi * static_cast<double>(labels.size())));
}

template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::CollectGapLengths(const LabelImageType * image, unsigned int axis,
                                                           double limit, std::vector<double> & lengths,
                                                           SizeValueType & numberOfContacts) const
{
  const double spacing = image->GetSpacing()[axis];

  ImageLinearConstIteratorWithIndex<LabelImageType> it(image, image->GetLargestPossibleRegion());
  it.SetDirection(axis);
  for (it.GoToBegin(); !it.IsAtEnd(); it.NextLine())
  {
    LabelPixelType cell = m_BackgroundLabel;
    SizeValueType  gap = 0;
    for (; !it.IsAtEndOfLine(); ++it)
    {
      const LabelPixelType label = it.Get();
      if (label == m_BackgroundLabel)
      {
        ++gap;
        continue;
      }
      const double length = static_cast<double>(gap) * spacing;
      if (gap > 0 && length <= limit && cell != m_BackgroundLabel && cell != label)
      {
        lengths.push_back(length);
      }
      numberOfContacts += gap == 0 && cell != m_BackgroundLabel && cell != label ? 1 : 0;
      cell = label;
      gap = 0;
    }
  }
}

template <typename TLabelImage>
auto
LabelGapClosingImageFilter<TLabelImage>::ComputeGapMask(double radius) -> MaskPointer
{
  const auto threshold = BinaryThresholdImageFilter<DistanceType, MaskType>::New();
  const auto closing = BinaryThresholdImageFilter<DistanceType, MaskType>::New();
  const auto outsideDistance = SignedMaurerDistanceMapImageFilter<MaskType, DistanceType>::New();
  const auto cellDistance = SignedMaurerDistanceMapImageFilter<LabelImageType, DistanceType>::New();
  cellDistance->SetInput(this->GetInput());
  cellDistance->SetBackgroundValue(m_BackgroundLabel);
  cellDistance->SetSquaredDistance(false);
  // The dilation is where the distance to the cells is at most the radius. Its erosion, the closing, is where the
  // distance to what the dilation leaves out is more than the radius.
  threshold->SetInput(cellDistance->GetOutput());
  threshold->SetUpperThreshold(static_cast<float>(radius));
  threshold->SetInsideValue(0);
  threshold->SetOutsideValue(1);
  outsideDistance->SetInput(threshold->GetOutput());
  outsideDistance->SetSquaredDistance(false);
  closing->SetInput(outsideDistance->GetOutput());
  closing->SetUpperThreshold(static_cast<float>(radius));
  closing->SetInsideValue(0);
  closing->SetOutsideValue(1);

  const auto progress = ProgressAccumulator::New();
  progress->SetMiniPipelineFilter(this);
  progress->RegisterInternalFilter(cellDistance, 0.4f);
  progress->RegisterInternalFilter(outsideDistance, 0.4f);
  closing->Update();
  return this->AddNarrowVoids(closing->GetOutput(), cellDistance->GetOutput());
}

template <typename TLabelImage>
auto
LabelGapClosingImageFilter<TLabelImage>::AddNarrowVoids(const MaskType * mask, const DistanceType * cellDistance) const
  -> MaskPointer
{
  const auto filled = BinaryFillholeImageFilter<MaskType>::New();
  filled->SetInput(mask);
  filled->SetForegroundValue(1);
  const auto voids = SubtractImageFilter<MaskType>::New();
  voids->SetInput1(filled->GetOutput());
  voids->SetInput2(mask);
  using OpeningType = BinaryStatisticsOpeningImageFilter<MaskType, DistanceType>;
  const auto narrowVoids = OpeningType::New();
  narrowVoids->SetInput(voids->GetOutput());
  narrowVoids->SetFeatureImage(cellDistance);
  narrowVoids->SetForegroundValue(1);
  narrowVoids->SetAttribute(OpeningType::LabelObjectType::MAXIMUM);
  narrowVoids->SetReverseOrdering(true);
  narrowVoids->SetLambda(m_UsedGapWidth);
  const auto sum = MaximumImageFilter<MaskType>::New();
  sum->SetInput1(mask);
  sum->SetInput2(narrowVoids->GetOutput());
  sum->Update();
  return sum->GetOutput();
}

template <typename TLabelImage>
auto
LabelGapClosingImageFilter<TLabelImage>::ComputeNeighbours(double radius) const -> std::vector<Neighbour>
{
  const auto                          spacing = this->GetInput()->GetSpacing();
  typename LabelImageType::OffsetType reach;
  std::transform(spacing.Begin(), spacing.End(), reach.begin(), [radius](double s) {
    return static_cast<OffsetValueType>(radius / s);
  });
  std::vector<Neighbour> neighbours;
  for (OffsetValueType z = -reach[2]; z <= reach[2]; ++z)
  {
    for (OffsetValueType y = -reach[1]; y <= reach[1]; ++y)
    {
      for (OffsetValueType x = -reach[0]; x <= reach[0]; ++x)
      {
        const double distance = std::hypot(x * spacing[0], y * spacing[1], z * spacing[2]);
        if (distance <= radius)
        {
          neighbours.push_back({ { { x, y, z } }, distance });
        }
      }
    }
  }
  std::stable_sort(neighbours.begin(), neighbours.end(), [](const Neighbour & a, const Neighbour & b) {
    return a.distance < b.distance;
  });
  return neighbours;
}

template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::GrowCells(const MaskType * mask, double radius)
{
  // Each voxel of the mask looks for its nearest cells in the input, so that the result does not depend on the order.
  const LabelImageType *       input = this->GetInput();
  const auto                   imageRegion = input->GetLargestPossibleRegion();
  const std::vector<Neighbour> neighbours = this->ComputeNeighbours(radius);
  std::mutex                   mutex;
  const auto                   grow = [&](const typename LabelImageType::RegionType & region) {
    SizeValueType                                numberOfChanges = 0;
    double                                       largestDistance = 0.0;
    ImageRegionConstIterator<MaskType>           maskIt(mask, region);
    ImageRegionIteratorWithIndex<LabelImageType> it(this->GetOutput(), region);
    for (; !it.IsAtEnd(); ++it, ++maskIt)
    {
      if (maskIt.Get() == 0 || it.Get() != m_BackgroundLabel)
      {
        continue;
      }
      const NearestCells cells = this->FindNearestCells(it.GetIndex(), neighbours);
      if (cells.number > 1)
      {
        it.Set(cells.nearest);
        ++numberOfChanges;
        largestDistance = std::max(largestDistance, cells.distance);
      }
    }
    const std::lock_guard<std::mutex> lock(mutex);
    m_NumberOfChangedVoxels += numberOfChanges;
    m_LargestDistance = std::max(m_LargestDistance, largestDistance);
  };
  this->GetMultiThreader()->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  this->GetMultiThreader()->template ParallelizeImageRegion<3>(imageRegion, grow, nullptr);
  this->UpdateProgress(1.0f);
}

template <typename TLabelImage>
auto
LabelGapClosingImageFilter<TLabelImage>::FindNearestCells(const IndexType &              index,
                                                          const std::vector<Neighbour> & neighbours) const
  -> NearestCells
{
  const LabelImageType * input = this->GetInput();
  const auto             region = input->GetLargestPossibleRegion();
  NearestCells           cells = { m_BackgroundLabel, 0.0, 0 };
  for (const Neighbour & neighbour : neighbours)
  {
    const bool isTie = cells.number > 0 && neighbour.distance <= cells.distance * (1.0 + 1e-9);
    if (cells.number > 1 && !isTie)
    {
      break;
    }
    const IndexType other = index + neighbour.offset;
    if (!region.IsInside(other) || input->GetPixel(other) == m_BackgroundLabel)
    {
      continue;
    }
    const LabelPixelType label = input->GetPixel(other);
    if (cells.number == 0)
    {
      cells = { label, neighbour.distance, 1 };
    }
    else if (label != cells.nearest)
    {
      cells.number = 2;
      cells.nearest = isTie ? std::min(label, cells.nearest) : cells.nearest;
    }
  }
  return cells;
}

template <typename TLabelImage>
void
LabelGapClosingImageFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using PrintType = typename NumericTraits<LabelPixelType>::PrintType;
  Superclass::PrintSelf(os, indent);
  os << indent << "BackgroundLabel: " << static_cast<PrintType>(m_BackgroundLabel) << std::endl;
  os << indent << "GapWidth: " << m_GapWidth << std::endl;
  os << indent << "UsedGapWidth: " << m_UsedGapWidth << std::endl;
  os << indent << "NumberOfChangedVoxels: " << m_NumberOfChangedVoxels << std::endl;
  os << indent << "LargestDistance: " << m_LargestDistance << std::endl;
  os << indent << "ShareOfGapsLeft: " << m_ShareOfGapsLeft << std::endl;
  os << indent << "WidthOfGapsLeft: " << m_WidthOfGapsLeft << std::endl;
}
} // namespace itk

#endif
