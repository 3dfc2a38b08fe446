/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellCoreImageFilter_hxx
#define itkCellCoreImageFilter_hxx

#include "itkCellCoreImageFilter.h"

#include "TissueTessellationCore/Image/LabelIndexer.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkMultiThreaderBase.h"
#include "itkProgressAccumulator.h"
#include "itkSignedMaurerDistanceMapImageFilter.h"

#include <algorithm>
#include <cmath>

namespace itk
{
template <typename TLabelImage>
void
CellCoreImageFilter<TLabelImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  const_cast<LabelImageType *>(this->GetInput())->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
void
CellCoreImageFilter<TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
auto
CellCoreImageFilter<TLabelImage>::ComputeDepth() -> typename DistanceImageType::Pointer
{
  // Voxels with another number beside them, along an axis, are marked in parallel; the depth is the distance to them.
  using MaskType = Image<unsigned char, 3>;
  const MarkerImageType * cells = this->GetOutput();
  const auto              whole = cells->GetLargestPossibleRegion();
  const auto              boundary = MaskType::New();
  boundary->CopyInformation(cells);
  boundary->SetRegions(whole);
  boundary->Allocate();
  const auto mark = [&](const typename MarkerImageType::RegionType & region) {
    for (ImageRegionIteratorWithIndex<MaskType> it(boundary, region); !it.IsAtEnd(); ++it)
    {
      bool isBoundary = false;
      for (unsigned int axis = 0; axis < 3; ++axis)
      {
        for (const IndexValueType step : { -1, 1 })
        {
          auto beside = it.GetIndex();
          beside[axis] += step;
          isBoundary =
            isBoundary || (whole.IsInside(beside) && cells->GetPixel(beside) != cells->GetPixel(it.GetIndex()));
        }
      }
      it.Set(isBoundary ? 1 : 0);
    }
  };
  this->GetMultiThreader()->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  this->GetMultiThreader()->template ParallelizeImageRegion<3>(whole, mark, nullptr);

  const auto distance = SignedMaurerDistanceMapImageFilter<MaskType, DistanceImageType>::New();
  distance->SetInput(boundary);
  distance->SetSquaredDistance(false);
  distance->SetUseImageSpacing(true);
  distance->SetNumberOfWorkUnits(this->GetNumberOfWorkUnits());
  const auto progress = ProgressAccumulator::New();
  progress->SetMiniPipelineFilter(this);
  progress->RegisterInternalFilter(distance, 0.8f);
  distance->Update();
  return distance->GetOutput();
}

template <typename TLabelImage>
std::vector<SizeValueType>
CellCoreImageFilter<TLabelImage>::NumberCells()
{
  const LabelImageType * input = this->GetInput();
  const auto             region = input->GetLargestPossibleRegion();
  tissue::LabelIndexer   indexOf({ true, static_cast<tissue::Label>(m_ExteriorLabel) });

  std::vector<SizeValueType>               numberOfVoxels;
  ImageRegionConstIterator<LabelImageType> label(input, region);
  for (ImageRegionIterator<MarkerImageType> it(this->GetOutput(), region); !it.IsAtEnd(); ++it, ++label)
  {
    const auto marker = static_cast<std::uint32_t>(indexOf(static_cast<tissue::Label>(label.Get()))) + 1;
    numberOfVoxels.resize(std::max<std::size_t>(numberOfVoxels.size(), marker + 1));
    ++numberOfVoxels[marker];
    it.Set(marker);
  }
  m_Labels.assign(indexOf.GetLabels().begin() + 1, indexOf.GetLabels().end());
  return numberOfVoxels;
}

template <typename TLabelImage>
void
CellCoreImageFilter<TLabelImage>::GenerateData()
{
  // Number the cells, compute depths, find the least depth of each marker, and take the voxels of less depth off it.
  this->AllocateOutputs();
  MarkerImageType * const output = this->GetOutput();
  const auto              region = output->GetLargestPossibleRegion();
  const auto              numberOfVoxels = this->NumberCells();
  if (m_Labels.empty())
  {
    itkExceptionMacro(<< "The label image has no cell, but the exterior "
                      << static_cast<typename NumericTraits<LabelPixelType>::PrintType>(m_ExteriorLabel) << " alone");
  }
  const typename DistanceImageType::Pointer depth = this->ComputeDepth();

  std::vector<float>                          least(m_Labels.size() + 2, 0.0f);
  ImageRegionConstIterator<DistanceImageType> depthIt(depth, region);
  for (ImageRegionConstIterator<MarkerImageType> it(output, region); !it.IsAtEnd(); ++it, ++depthIt)
  {
    least[it.Get()] = std::max(least[it.Get()], static_cast<float>(m_CoreDepth) * depthIt.Get());
  }
  double numberOfCellVoxels = 0.0;
  for (std::size_t marker = 2; marker < numberOfVoxels.size(); ++marker)
  {
    numberOfCellVoxels += static_cast<double>(numberOfVoxels[marker]);
  }
  const auto   spacing = output->GetSpacing();
  const double meanVolume =
    numberOfCellVoxels * spacing[0] * spacing[1] * spacing[2] / static_cast<double>(m_Labels.size());
  least[1] = static_cast<float>(m_ExteriorMargin * std::cbrt(6.0 * meanVolume / Math::pi));
  depthIt.GoToBegin();
  for (ImageRegionIterator<MarkerImageType> it(output, region); !it.IsAtEnd(); ++it, ++depthIt)
  {
    // Where cells are so thin that they are all boundary, the signed distance is 0 or less, and stands for a depth of
    // 0.
    if (std::max(depthIt.Get(), 0.0f) < least[it.Get()])
    {
      it.Set(0);
    }
  }
}

template <typename TLabelImage>
void
CellCoreImageFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  using PrintType = typename NumericTraits<LabelPixelType>::PrintType;
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabel: " << static_cast<PrintType>(m_ExteriorLabel) << std::endl;
  os << indent << "CoreDepth: " << m_CoreDepth << std::endl;
  os << indent << "ExteriorMargin: " << m_ExteriorMargin << std::endl;
}
} // namespace itk

#endif
