/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelJunctionExtractionFilter_hxx
#define itkLabelJunctionExtractionFilter_hxx

#include "itkLabelJunctionExtractionFilter.h"

#include "TissueTessellationCore/Image/BlockScan.h"
#include "TissueTessellationCore/Image/GatherJunctions.h"
#include "itkContinuousIndex.h"
#include "itkEnclosedVoidImageFilter.h"
#include "itkExteriorLabelImageCalculator.h"
#include "itkMultiThreaderBase.h"
#include "itkTotalProgressReporter.h"
#include "itkWorkUnitErrors.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <mutex>
#include <type_traits>

namespace itk
{
template <typename TLabelImage>
LabelJunctionExtractionFilter<TLabelImage>::LabelJunctionExtractionFilter()
{
  static_assert(LabelImageType::ImageDimension == 3, "A tissue is an image in three dimensions.");
  static_assert(std::is_integral<LabelPixelType>::value, "Labels are integers.");
  this->SetNumberOfRequiredInputs(1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::SetInput(const LabelImageType * image)
{
  // The pipeline is not const-correct.
  this->ProcessObject::SetNthInput(0, const_cast<LabelImageType *>(image));
}

template <typename TLabelImage>
auto
LabelJunctionExtractionFilter<TLabelImage>::GetInput() const -> const LabelImageType *
{
  return itkDynamicCastInDebugMode<const LabelImageType *>(this->GetPrimaryInput());
}

template <typename TLabelImage>
auto
LabelJunctionExtractionFilter<TLabelImage>::GetOutput() -> OutputType *
{
  return itkDynamicCastInDebugMode<OutputType *>(this->GetPrimaryOutput());
}

template <typename TLabelImage>
auto
LabelJunctionExtractionFilter<TLabelImage>::GetOutput() const -> const OutputType *
{
  return itkDynamicCastInDebugMode<const OutputType *>(this->GetPrimaryOutput());
}

template <typename TLabelImage>
ProcessObject::DataObjectPointer
LabelJunctionExtractionFilter<TLabelImage>::MakeOutput(ProcessObject::DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::SetExteriorLabel(tissue::Label label)
{
  if (m_AutomaticExteriorLabel || m_ExteriorLabel != label)
  {
    m_AutomaticExteriorLabel = false;
    m_ExteriorLabel = label;
    this->Modified();
  }
}

template <typename TLabelImage>
tissue::Label
LabelJunctionExtractionFilter<TLabelImage>::GetUsedExteriorLabel() const
{
  const auto & cells = this->GetOutput()->GetJunctionSet().cells;
  if (cells.empty())
  {
    itkExceptionMacro(<< "The exterior label used is known after the update only.");
  }
  return cells[tissue::ExteriorVertex].label;
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::GenerateData()
{
  using tissue::BlockScan;
  const LabelImageType * image = this->GetInput();
  tissue::ExteriorLabels exterior{ true, m_ExteriorLabel, m_ZeroIsCell };
  if (m_AutomaticExteriorLabel)
  {
    const auto calculator = ExteriorLabelImageCalculator<LabelImageType>::New();
    calculator->SetImage(image);
    calculator->SetZeroIsCell(m_ZeroIsCell);
    calculator->Compute();
    exterior.hasLabel = calculator->GetHasExteriorLabel();
    exterior.label = calculator->GetExteriorLabel();
  }

  BlockScan::Index size;
  const auto       imageSize = image->GetLargestPossibleRegion().GetSize();
  std::copy_n(imageSize.begin(), 3, size.begin());
  m_Voids = nullptr;
  auto junctions = [&]() {
    const ScanMap scans = this->ScanImage(size, exterior);
    auto          result = this->Gather(scans, size, exterior);
    this->CheckCells(scans, result);
    return result;
  }();
  if (m_SeparateVoids && junctions.cells[tissue::ExteriorVertex].numberOfPieces > 1)
  {
    this->SeparateVoidsOf(junctions, size, exterior);
  }
  this->TransformToPhysicalSpace(junctions);
  this->GetOutput()->SetJunctionSet(std::move(junctions));
  this->UpdateProgress(1.0f);
}

template <typename TLabelImage>
tissue::JunctionSet
LabelJunctionExtractionFilter<TLabelImage>::Gather(const ScanMap &                     scansByPlane,
                                                   const std::array<std::int32_t, 3> & size,
                                                   const tissue::ExteriorLabels &      exterior) const
{
  std::vector<const tissue::BlockScan *> scans;
  for (const auto & scan : scansByPlane)
  {
    scans.push_back(scan.second.get());
  }
  const auto spacing = this->GetInput()->GetSpacing();
  return tissue::GatherJunctions(scans, size, { { spacing[0], spacing[1], spacing[2] } }, exterior);
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::SeparateVoidsOf(tissue::JunctionSet &               junctions,
                                                            const std::array<std::int32_t, 3> & size,
                                                            tissue::ExteriorLabels              exterior)
{
  using VoidFilterType = EnclosedVoidImageFilter<LabelImageType>;
  const auto voids = VoidFilterType::New();
  voids->SetInput(this->GetInput());
  voids->SetExteriorLabels(&exterior);
  voids->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  voids->Update();
  const tissue::Label largest = std::max(junctions.cells.back().label, exterior.label);
  if (voids->GetNumberOfVoids() == 0 ||
      largest > std::numeric_limits<tissue::Label>::max() - static_cast<tissue::Label>(voids->GetNumberOfVoids()))
  {
    return;
  }
  m_Voids = voids->GetOutput();
  m_FirstVoidLabel = largest + 1;
  exterior.numberOfVoids = static_cast<std::int32_t>(voids->GetNumberOfVoids());
  junctions = this->Gather(this->ScanImage(size, exterior), size, exterior);
  m_Voids = nullptr;
}

template <typename TLabelImage>
auto
LabelJunctionExtractionFilter<TLabelImage>::ScanImage(const std::array<std::int32_t, 3> & size,
                                                      const tissue::ExteriorLabels &      exterior) -> ScanMap
{
  ScanMap             scans;
  std::mutex          mutex;
  WorkUnitErrors      errors;
  const SizeValueType numberOfPlanes = static_cast<SizeValueType>(size[2]) + 1;
  const auto          scanPlanes = [&](const ImageRegion<1> & planes) {
    errors.Run([&]() {
      // One step is left to the end: ITK's progress, a fixed-point number, wraps to 0 where rounding takes it beyond 1.
      // The few images that are scanned again do not report it twice.
      TotalProgressReporter progress(m_Voids ? nullptr : this, numberOfPlanes + 1);
      const IndexValueType  first = planes.GetIndex(0);
      auto scan = std::make_shared<tissue::BlockScan>(size, static_cast<std::int32_t>(first), exterior);
      this->ScanPlane(first - 1, *scan);
      for (SizeValueType i = 0; i < planes.GetSize(0); ++i)
      {
        this->ScanPlane(first + static_cast<IndexValueType>(i), *scan);
        progress.Completed(1);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      scans[first] = std::move(scan);
    });
  };
  this->GetMultiThreader()->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  this->GetMultiThreader()->template ParallelizeImageRegion<1>(
    ImageRegion<1>({ { 1 } }, { { numberOfPlanes } }), scanPlanes, nullptr);
  errors.Rethrow();
  return scans;
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::ScanPlane(IndexValueType plane, tissue::BlockScan & scan) const
{
  const LabelImageType * image = this->GetInput();
  const auto             region = image->GetLargestPossibleRegion();
  const auto             sizeY = static_cast<IndexValueType>(region.GetSize(1));
  const bool             isInImage = plane >= 1 && plane <= static_cast<IndexValueType>(region.GetSize(2));
  scan.BeginPlane();
  for (IndexValueType y = 0; y < sizeY + 2; ++y)
  {
    if (isInImage && y >= 1 && y <= sizeY)
    {
      const auto begin = region.GetIndex();
      const auto offset = image->ComputeOffset({ { begin[0], begin[1] + y - 1, begin[2] + plane - 1 } });
      const LabelPixelType * const row = image->GetBufferPointer() + offset;
      if (m_Voids)
      {
        this->ScanImageRow(row, m_Voids->GetBufferPointer() + offset, region.GetSize(0), scan);
      }
      else
      {
        this->ScanImageRow(row, region.GetSize(0), scan);
      }
    }
    scan.EndRow();
  }
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::ScanImageRow(const LabelPixelType * row, SizeValueType size,
                                                         tissue::BlockScan & scan) const
{
  // The ends of runs are marked by vector instructions, then searched for by others.
  constexpr SizeValueType              chunkSize = 256;
  std::array<unsigned char, chunkSize> isEnd;
  for (SizeValueType begin = 0; begin < size; begin += chunkSize)
  {
    const LabelPixelType * const chunk = row + begin;
    // The last voxel of the row always ends a run.
    const SizeValueType number = std::min(chunkSize, size - 1 - begin);
    for (SizeValueType i = 0; i < number; ++i)
    {
      isEnd[i] = chunk[i] != chunk[i + 1];
    }
    const unsigned char * end = isEnd.data();
    while ((end = static_cast<const unsigned char *>(std::memchr(end, 1, isEnd.data() + number - end))) != nullptr)
    {
      const auto i = end - isEnd.data();
      this->AddRun(chunk[i], begin + i + 1, scan);
      ++end;
    }
  }
  this->AddRun(row[size - 1], size, scan);
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::ScanImageRow(const LabelPixelType * row, const std::uint32_t * voids,
                                                         SizeValueType size, tissue::BlockScan & scan) const
{
  for (SizeValueType i = 0; i < size; ++i)
  {
    if (i + 1 == size || row[i] != row[i + 1] || voids[i] != voids[i + 1])
    {
      if (voids[i] != 0)
      {
        scan.AddRun(m_FirstVoidLabel + static_cast<tissue::Label>(voids[i] - 1), static_cast<std::int32_t>(i + 2));
      }
      else
      {
        this->AddRun(row[i], i + 1, scan);
      }
    }
  }
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::AddRun(LabelPixelType pixel, SizeValueType end,
                                                   tissue::BlockScan & scan) const
{
  constexpr tissue::Label limit = std::numeric_limits<tissue::Label>::max();
  if (std::is_unsigned<LabelPixelType>::value && sizeof(LabelPixelType) >= sizeof(tissue::Label) &&
      pixel > static_cast<LabelPixelType>(limit))
  {
    itkExceptionMacro(<< "Label " << pixel << " is above the limit of " << limit);
  }
  scan.AddRun(static_cast<tissue::Label>(pixel), static_cast<std::int32_t>(end + 1));
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::CheckCells(const ScanMap &             scans,
                                                       const tissue::JunctionSet & junctions) const
{
  const auto hasLabel = [this](const typename ScanMap::value_type & scan) {
    return scan.second->GetLabels().HasMet(m_ExteriorLabel);
  };
  if (!m_AutomaticExteriorLabel && std::none_of(scans.cbegin(), scans.cend(), hasLabel))
  {
    itkExceptionMacro(<< "The exterior label " << m_ExteriorLabel << " is not a label of the image, which has "
                      << junctions.cells.size() - 1 << " labels" << (m_ZeroIsCell ? "" : " other than 0"));
  }
  constexpr std::size_t minimum = 4;
  if (junctions.cells.size() - 1 < minimum)
  {
    itkExceptionMacro(<< "The image has " << junctions.cells.size() - 1 << " cells, at least " << minimum
                      << " are needed; the exterior label is " << junctions.cells[tissue::ExteriorVertex].label
                      << (m_AutomaticExteriorLabel ? " (found automatically)" : ""));
  }
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::TransformToPhysicalSpace(tissue::JunctionSet & junctions) const
{
  const LabelImageType * image = this->GetInput();
  const auto             begin = image->GetLargestPossibleRegion().GetIndex();
  const auto             transform = [image, &begin](tissue::Point & point) {
    ContinuousIndex<double, 3> index;
    for (unsigned int i = 0; i < 3; ++i)
    {
      index[i] = static_cast<double>(begin[i]) + point[i];
    }
    Point<double, 3> physical;
    image->TransformContinuousIndexToPhysicalPoint(index, physical);
    std::copy_n(physical.Begin(), 3, point.begin());
  };
  for (std::size_t i = 1; i < junctions.cells.size(); ++i)
  {
    transform(junctions.cells[i].center);
  }
  for (tissue::Cell & enclosed : junctions.voids)
  {
    transform(enclosed.center);
  }
  for (tissue::Wall & wall : junctions.walls)
  {
    transform(wall.center);
  }
  for (tissue::Junction & junction : junctions.junctions)
  {
    transform(junction.position);
  }
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabel: " << m_ExteriorLabel << std::endl;
  os << indent << "AutomaticExteriorLabel: " << m_AutomaticExteriorLabel << std::endl;
  os << indent << "ZeroIsCell: " << m_ZeroIsCell << std::endl;
  os << indent << "SeparateVoids: " << m_SeparateVoids << std::endl;
}
} // namespace itk

#endif
