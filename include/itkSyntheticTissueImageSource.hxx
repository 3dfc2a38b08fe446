/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkSyntheticTissueImageSource_hxx
#define itkSyntheticTissueImageSource_hxx

#include "itkSyntheticTissueImageSource.h"

#include "TissueTessellationCore/Tessellation/SyntheticCells.h"
#include "TissueTessellationCore/Tessellation/TissueShapes.h"
#include "itkCoreExecution.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageScanlineIterator.h"
#include "itkMajorityLabelImageFilter.h"
#include "itkMergeLabelFragmentsImageFilter.h"
#include "itkTessellationBricks.h"
#include "itkTotalProgressReporter.h"
#include "itkWorkUnitErrors.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace itk
{
namespace SyntheticTissue
{
// The smallest mean volume of cells, in voxels. With less than a cube of 3, cells would be all boundary, and some would
// be lost to the smoothing of walls.
constexpr SizeValueType MinimumVoxelsPerCell = 27;

// The progress at which each phase starts, 0 .. 1, which is about its share of the time so far.
constexpr float GrowthStart = 0.1f;
constexpr float AssignmentStart = 0.4f;
constexpr float SmoothingStart = 0.75f;
constexpr float MergingStart = 0.9f;
} // namespace SyntheticTissue

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::GenerateData()
{
  this->VerifyMargin();
  this->AllocateOutputs();
  this->GetMultiThreader()->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());

  const SizeValueType numberOfTissueVoxels = this->MarkTissue();
  const SizeValueType limit = numberOfTissueVoxels / SyntheticTissue::MinimumVoxelsPerCell;
  if (limit < m_NumberOfCells)
  {
    itkExceptionMacro("NumberOfCells is " << m_NumberOfCells << ", but the " << m_Shape << " has only "
                                          << numberOfTissueVoxels << " voxels in this image, enough for " << limit
                                          << " cells of " << SyntheticTissue::MinimumVoxelsPerCell << " voxels");
  }
  double volume = static_cast<double>(numberOfTissueVoxels);
  for (const double spacing : this->GetOutput()->GetSpacing())
  {
    volume *= spacing;
  }
  const double cellDiameter = std::cbrt(volume / m_NumberOfCells);
  this->AssignCells(this->GrowCells(cellDiameter), cellDiameter);
  this->SmoothWalls();
  this->MergeFragments();
  this->VerifyCells();
  this->UpdateProgress(1.0f);
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::VerifyPreconditions() ITKv5_CONST
{
  Superclass::VerifyPreconditions();
  for (const double spacing : this->GetSpacing())
  {
    if (!(spacing > 0.0) || std::isinf(spacing))
    {
      itkExceptionMacro("Spacing is " << this->GetSpacing() << ", but must be finite and positive");
    }
  }
  if (m_NumberOfCells == 0)
  {
    itkExceptionMacro("NumberOfCells is 0, but must be at least 1");
  }
  if (!(m_Anisotropy >= 1.0) || std::isinf(m_Anisotropy))
  {
    itkExceptionMacro("Anisotropy is " << m_Anisotropy << ", but must be a finite number of at least 1");
  }
  const uint64_t greatest = NumericTraits<PixelType>::max();
  const uint64_t available = greatest - static_cast<uint64_t>(m_FirstCellLabel);
  if (this->GetLabelOffset(m_NumberOfCells - 1) > available)
  {
    itkExceptionMacro("The labels of " << m_NumberOfCells << " cells, from " << m_FirstCellLabel + 0
                                       << " on without the exterior's, exceed the pixel type's greatest value of "
                                       << greatest);
  }
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::VerifyMargin() const
{
  const SizeType size = this->GetOutput()->GetLargestPossibleRegion().GetSize();
  for (unsigned int i = 0; i < 3; ++i)
  {
    if (size[i] / 2 < m_Margin || size[i] == 2 * m_Margin)
    {
      itkExceptionMacro("The image's size is " << size << ", which a Margin of " << m_Margin
                                               << " voxels at each side leaves nothing of");
    }
  }
}

template <typename TOutputImage>
uint64_t
SyntheticTissueImageSource<TOutputImage>::GetLabelOffset(uint64_t cell) const
{
  const uint64_t exteriorOffset = static_cast<uint64_t>(m_ExteriorLabel) - static_cast<uint64_t>(m_FirstCellLabel);
  return m_ExteriorLabel >= m_FirstCellLabel && exteriorOffset <= cell ? cell + 1 : cell;
}

template <typename TOutputImage>
auto
SyntheticTissueImageSource<TOutputImage>::GetLabelOfCell(uint64_t cell) const -> PixelType
{
  return static_cast<PixelType>(static_cast<uint64_t>(m_FirstCellLabel) + this->GetLabelOffset(cell));
}

template <typename TOutputImage>
bool
SyntheticTissueImageSource<TOutputImage>::IsInside(const IndexType & index) const
{
  const RegionType region = this->GetOutput()->GetLargestPossibleRegion();
  tissue::Point    point;
  for (unsigned int i = 0; i < 3; ++i)
  {
    // Twice the distance from the middle of the image, in voxels, is an integer, and the same on every machine.
    const auto twice = static_cast<double>(2 * (index[i] - region.GetIndex(i)) + 1) - region.GetSize(i);
    point[i] = twice / static_cast<double>(region.GetSize(i) - 2 * m_Margin);
    if (std::abs(point[i]) > 1.0)
    {
      return false;
    }
  }
  switch (m_Shape)
  {
    case ShapeEnum::Dome:
      return tissue::IsInsideDome(point);
    case ShapeEnum::Flower:
      return tissue::IsInsideFlower(point);
    case ShapeEnum::Block:
      break;
  }
  return true;
}

template <typename TOutputImage>
SizeValueType
SyntheticTissueImageSource<TOutputImage>::MarkTissue()
{
  OutputImageType *          output = this->GetOutput();
  const RegionType           region = output->GetRequestedRegion();
  const PixelType            cellLabel = this->GetLabelOfCell(0);
  std::atomic<SizeValueType> numberOfTissueVoxels{ 0 };
  WorkUnitErrors             errors;
  const auto                 mark = [&](const RegionType & chunk) {
    errors.Run([&]() {
      TotalProgressReporter progress(this, region.GetNumberOfPixels(), 100, SyntheticTissue::GrowthStart);
      SizeValueType         count = 0;
      ImageScanlineIterator<OutputImageType> it(output, chunk);
      for (; !it.IsAtEnd(); it.NextLine())
      {
        IndexType index = it.GetIndex();
        for (; !it.IsAtEndOfLine(); ++it, ++index[0])
        {
          const bool isInside = this->IsInside(index);
          it.Set(isInside ? cellLabel : m_ExteriorLabel);
          count += isInside ? 1 : 0;
        }
        progress.Completed(chunk.GetSize(0));
      }
      numberOfTissueVoxels += count;
    });
  };
  this->GetMultiThreader()->template ParallelizeImageRegionRestrictDirection<3>(0, region, mark, nullptr);
  errors.Rethrow();
  return numberOfTissueVoxels;
}

template <typename TOutputImage>
tissue::AnisotropicTessellation
SyntheticTissueImageSource<TOutputImage>::GrowCells(double cellDiameter)
{
  constexpr std::int32_t       cellsPerFounder = 16; // This makes about four generations of divisions.
  tissue::SyntheticCellOptions options;
  options.numberOfCells = static_cast<std::int32_t>(m_NumberOfCells);
  options.seed = m_Seed;
  options.anisotropy = m_CellModel == CellModelEnum::Anisotropic ? m_Anisotropy : 1.0;
  options.numberOfFounders = m_CellModel == CellModelEnum::Division
                               ? std::max(1, options.numberOfCells / cellsPerFounder)
                               : options.numberOfCells;
  return RunCore(this, [&] {
    return tissue::GrowSyntheticCells(
      TessellationBricks::SampleTissue(this->GetOutput(), m_ExteriorLabel, cellDiameter),
      options,
      MakeExecution(this, SyntheticTissue::GrowthStart, SyntheticTissue::AssignmentStart));
  });
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::AssignCells(const tissue::AnisotropicTessellation & cells,
                                                      double                                  cellDiameter)
{
  // Bricks of half a cell's diameter are worked on in parallel. The seeds that can be nearest to any voxel of a brick
  // are looked up once, when its first voxel of the tissue is met; then each voxel takes the label of its nearest seed.
  OutputImageType * output = this->GetOutput();
  const RegionType  region = output->GetRequestedRegion();
  const SizeType    brickSize = TessellationBricks::SizeOfLength(output, 0.5 * cellDiameter);
  WorkUnitErrors    errors;
  const auto        assign = [&](const RegionType & chunk) {
    errors.Run([&]() {
      TotalProgressReporter progress(
        this, region.GetNumberOfPixels(), 100, SyntheticTissue::SmoothingStart - SyntheticTissue::AssignmentStart);
      std::vector<tissue::AnisotropicTessellation::SeedId> candidates;
      TessellationBricks::VisitBricks(chunk, brickSize, [&](const RegionType & brick) {
        candidates.clear();
        ImageScanlineIterator<OutputImageType> it(output, brick);
        for (; !it.IsAtEnd(); it.NextLine())
        {
          for (IndexType index = it.GetIndex(); !it.IsAtEndOfLine(); ++it, ++index[0])
          {
            if (it.Get() == m_ExteriorLabel)
            {
              continue;
            }
            if (candidates.empty())
            {
              const auto ball = TessellationBricks::EnclosingBall(output, brick);
              cells.FindCandidates(ball.center, ball.radius, candidates);
            }
            const tissue::Point point = TessellationBricks::ToTissuePoint(output, index);
            it.Set(this->GetLabelOfCell(static_cast<uint64_t>(cells.FindNearest(point, candidates))));
          }
        }
        progress.Completed(brick.GetNumberOfPixels());
      });
    });
  };
  this->GetMultiThreader()->template ParallelizeImageRegion<3>(region, assign, nullptr);
  errors.Rethrow();
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::RunOnOutput(ImageToImageFilter<TOutputImage, TOutputImage> * filter,
                                                      float progressStart, float progressEnd)
{
  // The filter's input is a graft, as with the output itself it would ask this source to update.
  auto input = OutputImageType::New();
  input->Graft(this->GetOutput());
  filter->SetInput(input);
  filter->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  filter->AddObserver(ProgressEvent(), [this, filter, progressStart, progressEnd](const EventObject &) {
    this->UpdateProgress(progressStart + (progressEnd - progressStart) * filter->GetProgress());
    filter->SetAbortGenerateData(this->GetAbortGenerateData());
  });
  filter->Update();
  if (this->GetAbortGenerateData())
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
  this->GetOutput()->SetPixelContainer(filter->GetOutput()->GetPixelContainer());
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::SmoothWalls()
{
  for (unsigned int pass = 0; pass < m_Smoothing; ++pass)
  {
    const float share = (SyntheticTissue::MergingStart - SyntheticTissue::SmoothingStart) / m_Smoothing;
    const float start = SyntheticTissue::SmoothingStart + pass * share;
    this->RunOnOutput(MajorityLabelImageFilter<OutputImageType>::New(), start, start + share);
  }
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::MergeFragments()
{
  using MergeFilterType = MergeLabelFragmentsImageFilter<OutputImageType>;
  auto merge = MergeFilterType::New();
  merge->SetExteriorLabel(m_ExteriorLabel);
  merge->InPlaceOn();
  this->RunOnOutput(merge.GetPointer(), SyntheticTissue::MergingStart, 1.0f);
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::VerifyCells() const
{
  std::vector<bool>                         isPresent(m_NumberOfCells + 1, false);
  ImageRegionConstIterator<OutputImageType> it(this->GetOutput(), this->GetOutput()->GetRequestedRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    if (it.Get() != m_ExteriorLabel)
    {
      isPresent[static_cast<uint64_t>(it.Get()) - static_cast<uint64_t>(m_FirstCellLabel)] = true;
    }
  }
  for (uint64_t cell = 0; cell < m_NumberOfCells; ++cell)
  {
    if (!isPresent[this->GetLabelOffset(cell)])
    {
      itkExceptionMacro("Of " << m_NumberOfCells << " cells, the one of label " << this->GetLabelOfCell(cell) + 0
                              << " was lost to the smoothing of walls: try less Smoothing than " << m_Smoothing
                              << ", fewer cells or a larger image");
    }
  }
}

template <typename TOutputImage>
void
SyntheticTissueImageSource<TOutputImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using PrintType = typename NumericTraits<PixelType>::PrintType;
  Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCells: " << m_NumberOfCells << std::endl;
  os << indent << "Seed: " << m_Seed << std::endl;
  os << indent << "Shape: " << m_Shape << std::endl;
  os << indent << "CellModel: " << m_CellModel << std::endl;
  os << indent << "Anisotropy: " << m_Anisotropy << std::endl;
  os << indent << "Margin: " << m_Margin << std::endl;
  os << indent << "Smoothing: " << m_Smoothing << std::endl;
  os << indent << "ExteriorLabel: " << static_cast<PrintType>(m_ExteriorLabel) << std::endl;
  os << indent << "FirstCellLabel: " << static_cast<PrintType>(m_FirstCellLabel) << std::endl;
}
} // namespace itk

#endif
