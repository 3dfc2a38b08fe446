/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMergeLabelFragmentsImageFilter_hxx
#define itkMergeLabelFragmentsImageFilter_hxx

#include "itkMergeLabelFragmentsImageFilter.h"

#include "TissueTessellationCore/Image/LabelFragments.h"
#include "itkProgressReporter.h"

#include <algorithm>

namespace itk
{
template <typename TImage>
void
MergeLabelFragmentsImageFilter<TImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  const_cast<ImageType *>(this->GetInput())->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TImage>
void
MergeLabelFragmentsImageFilter<TImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TImage>
tissue::LabelRuns
MergeLabelFragmentsImageFilter<TImage>::FindRuns()
{
  const ImageType *   input = this->GetInput();
  const RegionType    region = input->GetBufferedRegion();
  const SizeValueType rowSize = region.GetSize(0);
  const SizeValueType numberOfRows = region.GetSize(1) * region.GetSize(2);
  const PixelType *   begin = input->GetBufferPointer();
  ProgressReporter    progress(this, 0, numberOfRows, 50, 0.0f, 0.3f);
  tissue::LabelRuns   labels;
  labels.rowsPerLayer = region.GetSize(1);
  labels.endOfRow.reserve(numberOfRows);
  for (SizeValueType row = 0; row < numberOfRows; ++row, begin += rowSize)
  {
    const PixelType * end = begin + rowSize;
    for (const PixelType * run = begin; run != end;)
    {
      const PixelType * runEnd = std::find_if(run, end, [run](PixelType label) { return label != *run; });
      labels.runs.push_back({ static_cast<tissue::Label>(*run),
                              static_cast<std::int32_t>(run - begin),
                              static_cast<std::int32_t>(runEnd - begin) });
      run = runEnd;
    }
    labels.endOfRow.push_back(labels.runs.size());
    progress.CompletedPixel();
  }
  return labels;
}

template <typename TImage>
void
MergeLabelFragmentsImageFilter<TImage>::GenerateData()
{
  tissue::LabelRuns labels = this->FindRuns();
  m_NumberOfChangedVoxels =
    static_cast<SizeValueType>(tissue::MergeFragments(labels, static_cast<tissue::Label>(m_ExteriorLabel)));
  this->UpdateProgress(0.9f);

  this->AllocateOutputs();
  PixelType * voxel = this->GetOutput()->GetBufferPointer();
  for (const tissue::LabelRun & run : labels.runs)
  {
    voxel = std::fill_n(voxel, run.end - run.begin, static_cast<PixelType>(run.label));
  }
}

template <typename TImage>
void
MergeLabelFragmentsImageFilter<TImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "ExteriorLabel: " << static_cast<typename NumericTraits<PixelType>::PrintType>(m_ExteriorLabel)
     << std::endl;
  os << indent << "NumberOfChangedVoxels: " << m_NumberOfChangedVoxels << std::endl;
}
} // namespace itk

#endif
