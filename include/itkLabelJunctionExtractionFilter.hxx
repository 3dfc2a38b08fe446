/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelJunctionExtractionFilter_hxx
#define itkLabelJunctionExtractionFilter_hxx

#include "itkLabelJunctionExtractionFilter.h"

#include "TissueTessellationCore/Adjacency/SuspectCells.h"
#include "TissueTessellationCore/Image/BlockScan.h"
#include "TissueTessellationCore/Image/GatherJunctions.h"
#include "TissueTessellationCore/Image/LabelIndexer.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkContinuousIndex.h"
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
  this->AddOptionalInputName("Votes", 1);
  this->SetNumberOfRequiredOutputs(1);
  this->SetNthOutput(0, this->MakeOutput(0));
  this->ProcessObject::SetOutput("LabelVolume", this->MakeOutput("LabelVolume"));
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
TissueLabelVolume *
LabelJunctionExtractionFilter<TLabelImage>::GetLabelVolume()
{
  return itkDynamicCastInDebugMode<TissueLabelVolume *>(this->ProcessObject::GetOutput("LabelVolume"));
}

template <typename TLabelImage>
const TissueLabelVolume *
LabelJunctionExtractionFilter<TLabelImage>::GetLabelVolume() const
{
  return itkDynamicCastInDebugMode<const TissueLabelVolume *>(this->ProcessObject::GetOutput("LabelVolume"));
}

template <typename TLabelImage>
ProcessObject::DataObjectPointer
LabelJunctionExtractionFilter<TLabelImage>::MakeOutput(ProcessObject::DataObjectPointerArraySizeType)
{
  return OutputType::New().GetPointer();
}

template <typename TLabelImage>
ProcessObject::DataObjectPointer
LabelJunctionExtractionFilter<TLabelImage>::MakeOutput(const ProcessObject::DataObjectIdentifierType & name)
{
  if (name == "LabelVolume")
  {
    return TissueLabelVolume::New().GetPointer();
  }
  return Superclass::MakeOutput(name);
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
tissue::ExteriorLabels
LabelJunctionExtractionFilter<TLabelImage>::FindExteriorLabels() const
{
  tissue::ExteriorLabels exterior;
  exterior.zeroIsCell = m_Exterior.zeroIsCell;
  std::vector<tissue::Label> labels = m_Exterior.labels;
  if (m_Exterior.isAutomatic)
  {
    const auto calculator = ExteriorLabelImageCalculator<LabelImageType>::New();
    calculator->SetImage(this->GetInput());
    calculator->SetZeroIsCell(m_Exterior.zeroIsCell);
    calculator->Compute();
    labels = calculator->GetExteriorLabels();
  }
  if (!labels.empty())
  {
    exterior.hasLabel = true;
    exterior.label = labels.front();
    exterior.others.assign(labels.begin() + 1, labels.end());
  }
  exterior.others.insert(exterior.others.end(), m_Exterior.dropped.begin(), m_Exterior.dropped.end());
  return exterior;
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::SetExterior(const ExteriorLabelSettings & settings)
{
  m_Exterior = settings;
  this->Modified();
}

template <typename TLabelImage>
tissue::JunctionSet
LabelJunctionExtractionFilter<TLabelImage>::Extract(const tissue::ExteriorLabels & exterior)
{
  tissue::BlockScan::Index size;
  const auto               imageSize = this->GetInput()->GetLargestPossibleRegion().GetSize();
  std::copy_n(imageSize.begin(), 3, size.begin());
  const ScanMap       scans = this->ScanImage(size, exterior);
  tissue::JunctionSet junctions = this->Gather(scans, size, exterior);
  this->CheckCells(scans, junctions);
  junctions.grid = this->DescribeGrid();
  return junctions;
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::GenerateData()
{
  tissue::ExteriorLabels exterior = this->FindExteriorLabels();
  tissue::JunctionSet    junctions = this->Extract(exterior);
  m_UsedDroppedLabels = m_Exterior.dropped;
  if (m_Exterior.dropsSuspects)
  {
    const std::vector<tissue::SuspectCell> suspects = tissue::FindSuspectCells(junctions);
    for (const tissue::SuspectCell & suspect : suspects)
    {
      exterior.others.push_back(junctions.cells[suspect.cell].label);
      m_UsedDroppedLabels.push_back(exterior.others.back());
    }
    if (!suspects.empty())
    {
      junctions = this->Extract(exterior);
    }
  }
  std::sort(m_UsedDroppedLabels.begin(), m_UsedDroppedLabels.end());
  if (m_GenerateLabelVolume)
  {
    this->GetLabelVolume()->SetLabelVolume(this->MakeLabelVolume(junctions));
  }
  junctions.votes = this->NumberVotes(junctions);
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
      TotalProgressReporter progress(this, numberOfPlanes + 1);
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
      this->ScanImageRow(row, region.GetSize(0), scan);
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
  const auto require = [&](tissue::Label label, const char * what) {
    const auto hasLabel = [label](const typename ScanMap::value_type & scan) {
      return scan.second->GetLabels().HasMet(label);
    };
    if (std::none_of(scans.cbegin(), scans.cend(), hasLabel))
    {
      itkExceptionMacro(<< what << label << " is not a label of the image, which has " << junctions.cells.size() - 1
                        << " labels" << (m_Exterior.zeroIsCell ? "" : " other than 0"));
    }
  };
  for (const tissue::Label label : m_Exterior.isAutomatic ? std::vector<tissue::Label>() : m_Exterior.labels)
  {
    require(label, "The exterior label ");
  }
  for (const tissue::Label label : m_Exterior.dropped)
  {
    require(label, "The label to be dropped ");
  }
  if (junctions.cells.size() < 2)
  {
    itkExceptionMacro(<< "The image has no cell; the exterior label is "
                      << junctions.cells[tissue::ExteriorVertex].label
                      << (m_Exterior.isAutomatic ? " (found automatically)" : ""));
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
tissue::ImageGrid
LabelJunctionExtractionFilter<TLabelImage>::DescribeGrid() const
{
  const LabelImageType * image = this->GetInput();
  const auto             region = image->GetLargestPossibleRegion();
  const auto             origin = image->template TransformIndexToPhysicalPoint<double>(region.GetIndex());
  tissue::ImageGrid      grid;
  for (unsigned int i = 0; i < 3; ++i)
  {
    grid.size[i] = static_cast<std::int32_t>(region.GetSize(i));
    grid.origin[i] = origin[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      grid.steps[i][j] = image->GetDirection()[j][i] * image->GetSpacing()[i];
    }
  }
  return grid;
}

template <typename TLabelImage>
std::unordered_map<tissue::Label, tissue::VertexId>
LabelJunctionExtractionFilter<TLabelImage>::NumberLabels(const tissue::JunctionSet & junctions)
{
  std::unordered_map<tissue::Label, tissue::VertexId> vertexOf;
  for (std::size_t v = 1; v < junctions.cells.size(); ++v)
  {
    vertexOf[junctions.cells[v].label] = static_cast<tissue::VertexId>(v);
  }
  return vertexOf;
}

template <typename TLabelImage>
std::vector<tissue::JunctionVote>
LabelJunctionExtractionFilter<TLabelImage>::NumberVotes(const tissue::JunctionSet & junctions) const
{
  if (this->GetVotes() == nullptr)
  {
    return {};
  }
  const auto vertexOf = NumberLabels(junctions);
  auto       votes = this->GetVotes()->GetVotes();
  for (tissue::JunctionVote & vote : votes)
  {
    // The vertices ascend with the labels, so a quadruple stays sorted.
    for (tissue::VertexId & cell : vote.cells)
    {
      const auto found = vertexOf.find(cell);
      if (cell != tissue::ExteriorVertex && found == vertexOf.end())
      {
        itkExceptionMacro(<< "A vote is on label " << cell << ", which is no cell of the image: it has "
                          << vertexOf.size() << " cells");
      }
      cell = cell == tissue::ExteriorVertex ? cell : found->second;
    }
  }
  return votes;
}

template <typename TLabelImage>
std::shared_ptr<const tissue::LabelVolume>
LabelJunctionExtractionFilter<TLabelImage>::MakeLabelVolume(const tissue::JunctionSet & junctions) const
{
  const auto volume = std::make_shared<tissue::LabelVolume>();
  volume->size = junctions.grid.size;
  volume->origin = junctions.grid.origin;
  volume->steps = junctions.grid.steps;
  this->NumberVoxels(junctions, *volume);
  return volume;
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::NumberVoxels(const tissue::JunctionSet & junctions,
                                                         tissue::LabelVolume &       volume) const
{
  const auto        vertexOf = NumberLabels(junctions);
  const std::size_t numberOfPixels = this->GetInput()->GetLargestPossibleRegion().GetNumberOfPixels();
  volume.vertices = tissue::VoxelVertices(
    numberOfPixels, tissue::ExteriorVertex, static_cast<tissue::VertexId>(junctions.cells.size()));
  const LabelPixelType * const pixels = this->GetInput()->GetBufferPointer();
  LabelPixelType               recent{};
  tissue::VertexId             vertex = -1;
  for (std::size_t i = 0; i < numberOfPixels; ++i)
  {
    if (vertex < 0 || pixels[i] != recent)
    {
      recent = pixels[i];
      const auto found = vertexOf.find(static_cast<tissue::Label>(recent));
      vertex = found != vertexOf.end() ? found->second : tissue::ExteriorVertex;
    }
    volume.vertices.Put(i, vertex);
  }
}

template <typename TLabelImage>
void
LabelJunctionExtractionFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  m_Exterior.Print(os, indent);
  os << indent << "GenerateLabelVolume: " << (m_GenerateLabelVolume ? "On" : "Off") << std::endl;
}
} // namespace itk

#endif
