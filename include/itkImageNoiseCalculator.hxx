/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkImageNoiseCalculator_hxx
#define itkImageNoiseCalculator_hxx

#include "itkImageNoiseCalculator.h"

#include "itkImageRegionConstIteratorWithOnlyIndex.h"
#include "itkMultiThreaderBase.h"

#include <algorithm>
#include <cmath>

namespace itk
{
template <typename TImage>
IndexValueType
ImageNoiseCalculator<TImage>::GetBegin(unsigned int axis, SizeValueType block) const
{
  const auto          region = m_Image->GetLargestPossibleRegion();
  const SizeValueType margin = this->Counts(axis) ? 1 : 0;
  const SizeValueType size = region.GetSize(axis) - 2 * margin;
  return region.GetIndex(axis) + static_cast<IndexValueType>(margin + size * block / m_NumberOfBlocks[axis]);
}

template <typename TImage>
double
ImageNoiseCalculator<TImage>::ComputeBlock(SizeValueType number) const
{
  const Triple block{ { number % m_NumberOfBlocks[0],
                        number / m_NumberOfBlocks[0] % m_NumberOfBlocks[1],
                        number / m_NumberOfBlocks[0] / m_NumberOfBlocks[1] } };
  // The steps in the buffer to the voxels of the second difference, and their weights.
  std::vector<std::pair<OffsetValueType, double>> weights{ { 0, 1.0 } };
  typename ImageType::RegionType                  region;
  double                                          variance = 1.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    region.SetIndex(axis, this->GetBegin(axis, block[axis]));
    region.SetSize(axis, static_cast<SizeValueType>(this->GetBegin(axis, block[axis] + 1) - region.GetIndex(axis)));
    if (this->Counts(axis))
    {
      const auto                                      stride = m_Image->GetOffsetTable()[axis];
      std::vector<std::pair<OffsetValueType, double>> wider;
      for (const auto & [step, weight] : weights)
      {
        wider.insert(wider.end(), { { step - stride, weight }, { step, -2.0 * weight }, { step + stride, weight } });
      }
      weights = wider;
      variance *= 6.0;
    }
  }
  std::vector<float> differences;
  differences.reserve(region.GetNumberOfPixels());
  for (ImageRegionConstIteratorWithOnlyIndex<ImageType> it(m_Image, region); !it.IsAtEnd(); ++it)
  {
    const auto * const pixel = m_Image->GetBufferPointer() + m_Image->ComputeOffset(it.GetIndex());
    double             difference = 0.0;
    for (const auto & [step, weight] : weights)
    {
      difference += weight * static_cast<double>(pixel[step]);
    }
    differences.push_back(static_cast<float>(std::abs(difference)));
  }
  // The absolute value of a normal variable is below 0.3186 deviations in a quarter of the cases.
  constexpr double quartileOfNormal = 0.3186;
  const auto       quartile = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 4);
  std::nth_element(differences.begin(), quartile, differences.end());
  return *quartile / (quartileOfNormal * std::sqrt(variance));
}

template <typename TImage>
void
ImageNoiseCalculator<TImage>::Compute()
{
  SizeValueType total = 1;
  bool          counts = false;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const SizeValueType size = m_Image->GetLargestPossibleRegion().GetSize(axis);
    m_NumberOfBlocks[axis] = std::max<SizeValueType>(1, (size + m_BlockSize / 2) / m_BlockSize);
    m_NumberOfBlocks[axis] = std::min(m_NumberOfBlocks[axis], this->Counts(axis) ? size - 2 : size);
    total *= m_NumberOfBlocks[axis];
    counts = counts || this->Counts(axis);
  }
  m_LocalDeviations.assign(total, 0.0);
  if (counts)
  {
    MultiThreaderBase::New()->ParallelizeArray(
      0, total, [this](SizeValueType number) { m_LocalDeviations[number] = this->ComputeBlock(number); }, nullptr);
  }
  std::vector<double> sorted = m_LocalDeviations;
  const auto          median = sorted.begin() + static_cast<std::ptrdiff_t>(total / 2);
  std::nth_element(sorted.begin(), median, sorted.end());
  m_Deviation = *median;
}

template <typename TImage>
double
ImageNoiseCalculator<TImage>::GetLocalDeviation(const IndexType & index) const
{
  SizeValueType number = 0;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int axis = 2 - i;
    SizeValueType      block = 0;
    while (block + 1 < m_NumberOfBlocks[axis] && index[axis] >= this->GetBegin(axis, block + 1))
    {
      ++block;
    }
    number = number * m_NumberOfBlocks[axis] + block;
  }
  return m_LocalDeviations[number];
}

template <typename TImage>
void
ImageNoiseCalculator<TImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Image);
  os << indent << "BlockSize: " << m_BlockSize << std::endl;
  os << indent << "Deviation: " << m_Deviation << std::endl;
}
} // namespace itk

#endif
