/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMajorityLabelImageFilter_hxx
#define itkMajorityLabelImageFilter_hxx

#include "itkMajorityLabelImageFilter.h"

#include "itkImageScanlineIterator.h"
#include "itkTotalProgressReporter.h"

#include <algorithm>
#include <utility>

namespace itk
{
template <typename TImage>
MajorityLabelImageFilter<TImage>::MajorityLabelImageFilter()
{
  this->DynamicMultiThreadingOn();
  this->ThreaderUpdateProgressOff();
}

template <typename TImage>
void
MajorityLabelImageFilter<TImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  auto *     input = const_cast<ImageType *>(this->GetInput());
  RegionType region = input->GetRequestedRegion();
  region.PadByRadius(1);
  region.Crop(input->GetLargestPossibleRegion());
  input->SetRequestedRegion(region);
}

template <typename TImage>
auto
MajorityLabelImageFilter<TImage>::GetRows(const IndexType & index) const -> RowsType
{
  const ImageType * input = this->GetInput();
  const IndexType   first = input->GetBufferedRegion().GetIndex();
  const IndexType   last = input->GetBufferedRegion().GetUpperIndex();
  RowsType          rows;
  for (int row = 0; row < 9; ++row)
  {
    const IndexType rowStart = { { first[0],
                                   std::min(std::max(index[1] + row % 3 - 1, first[1]), last[1]),
                                   std::min(std::max(index[2] + row / 3 - 1, first[2]), last[2]) } };
    rows[row] = input->GetBufferPointer() + input->ComputeOffset(rowStart);
  }
  return rows;
}

template <typename TImage>
auto
MajorityLabelImageFilter<TImage>::FindMajority(const RowsType & rows, SizeValueType before, SizeValueType x,
                                               SizeValueType after) -> PixelType
{
  // Each of the 27 voxels votes for its label, in a list of labels with their weights. Weights of rows are the products
  // of 1, 2, 1 along y and z; along x the middle voxel counts twice.
  constexpr int                             rowWeights[9] = { 1, 2, 1, 2, 4, 2, 1, 2, 1 };
  std::array<std::pair<PixelType, int>, 27> votes;
  auto                                      end = votes.begin();
  const auto                                vote = [&](PixelType label, int weight) {
    const auto found = std::find_if(votes.begin(), end, [label](const auto & entry) { return entry.first == label; });
    if (found == end)
    {
      *end++ = { label, weight };
    }
    else
    {
      found->second += weight;
    }
  };
  for (int row = 0; row < 9; ++row)
  {
    vote(rows[row][before], rowWeights[row]);
    vote(rows[row][x], 2 * rowWeights[row]);
    vote(rows[row][after], rowWeights[row]);
  }
  const PixelType own = rows[4][x];
  const auto      isLess = [own](const auto & a, const auto & b) {
    if (a.second != b.second)
    {
      return a.second < b.second;
    }
    return a.first != own && (b.first == own || b.first < a.first);
  };
  return std::max_element(votes.begin(), end, isLess)->first;
}

template <typename TImage>
void
MajorityLabelImageFilter<TImage>::DynamicThreadedGenerateData(const RegionType & region)
{
  ImageType *         output = this->GetOutput();
  const RegionType    buffered = this->GetInput()->GetBufferedRegion();
  const SizeValueType lastX = buffered.GetSize(0) - 1;
  const SizeValueType firstX = region.GetIndex(0) - buffered.GetIndex(0);

  TotalProgressReporter            progress(this, output->GetRequestedRegion().GetNumberOfPixels());
  std::vector<unsigned char>       isMixed(lastX + 1);
  ImageScanlineIterator<ImageType> it(output, region);
  for (; !it.IsAtEnd(); it.NextLine())
  {
    const RowsType    rows = this->GetRows(it.GetIndex());
    const PixelType * own = rows[4];
    // Columns in which the nine rows differ are marked first. Most voxels are far from any boundary, and this loop over
    // whole rows is vectorized.
    std::fill(isMixed.begin(), isMixed.end(), 0);
    for (const PixelType * row : rows)
    {
      for (SizeValueType x = 0; x <= lastX; ++x)
      {
        isMixed[x] |= static_cast<unsigned char>(row[x] != own[x]);
      }
    }
    for (SizeValueType x = firstX; !it.IsAtEndOfLine(); ++it, ++x)
    {
      const SizeValueType before = x == 0 ? 0 : x - 1;
      const SizeValueType after = x == lastX ? x : x + 1;
      const bool          isUniform =
        !isMixed[before] && !isMixed[x] && !isMixed[after] && own[before] == own[x] && own[after] == own[x];
      it.Set(isUniform ? own[x] : FindMajority(rows, before, x, after));
    }
    progress.Completed(region.GetSize(0));
  }
}
} // namespace itk

#endif
