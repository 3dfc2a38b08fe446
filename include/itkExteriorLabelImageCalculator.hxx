/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkExteriorLabelImageCalculator_hxx
#define itkExteriorLabelImageCalculator_hxx

#include "itkExteriorLabelImageCalculator.h"

#include <algorithm>
#include <iterator>

namespace itk
{
template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::Compute()
{
  static_assert(LabelImageType::ImageDimension == 3, "A tissue is an image in three dimensions.");

  m_ExteriorLabels.clear();
  Sights sights;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    this->LookAlong(axis, sights);
  }
  if (2 * sights.numberOfLinesFromZero > sights.numberOfLines)
  {
    this->JudgePadding(sights);
    return;
  }
  std::vector<tissue::Label> often;
  for (const auto & [label, seen] : sights.ofLabel)
  {
    if (label != 0 && 8 * seen.number >= sights.numberOfLines)
    {
      often.push_back(label);
    }
  }
  if (often.empty())
  {
    return;
  }
  const VolumeMap volumes = this->CountVoxels();
  std::copy_if(often.begin(), often.end(), std::back_inserter(m_ExteriorLabels), [&](tissue::Label label) {
    return this->IsExterior(label, sights, volumes);
  });
  std::stable_sort(m_ExteriorLabels.begin(), m_ExteriorLabels.end(), [&](tissue::Label a, tissue::Label b) {
    return sights.ofLabel.at(a).number > sights.ofLabel.at(b).number;
  });
}

namespace ExteriorLabelDetail
{
/** Of the labels but one, which are one at least. */
inline SizeValueType
MedianOfOthers(const std::map<tissue::Label, SizeValueType> & volumes, tissue::Label label)
{
  std::vector<SizeValueType> others;
  for (const auto & [other, volume] : volumes)
  {
    if (other != label)
    {
      others.push_back(volume);
    }
  }
  const auto median = others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2);
  std::nth_element(others.begin(), median, others.end());
  return *median;
}
} // namespace ExteriorLabelDetail

template <typename TLabelImage>
bool
ExteriorLabelImageCalculator<TLabelImage>::IsExterior(tissue::Label label, const Sights & sights,
                                                      const VolumeMap & volumes) const
{
  const LabelSights & seen = sights.ofLabel.at(label);
  SizeValueType       second = 0;
  for (const auto & [other, ofOther] : sights.ofLabel)
  {
    second = other != label ? std::max(second, ofOther.number) : second;
  }
  const auto numberOfSides = std::count_if(
    seen.numberFromSide.begin(), seen.numberFromSide.end(), [](SizeValueType number) { return number > 0; });
  const bool dominates = seen.number >= 4 * second;
  if (volumes.size() < 2 || (dominates && numberOfSides > 2))
  {
    return dominates;
  }
  const SizeValueType volume = volumes.at(label);
  const SizeValueType median = ExteriorLabelDetail::MedianOfOthers(volumes, label);
  return (dominates && volume >= 2 * median) || (numberOfSides >= 5 && volume >= 8 * median);
}

template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::JudgePadding(const Sights & sights)
{
  SizeValueType total = 0;
  for (const auto & [label, seen] : sights.ofLabel)
  {
    total += seen.number;
  }
  for (const auto & [label, seen] : sights.ofLabel)
  {
    if (20 * seen.number < 19 * total)
    {
      continue;
    }
    SizeValueType flat = 0;
    for (const auto & numberAtDepth : seen.numberAtDepth)
    {
      SizeValueType most = 0;
      for (const auto & [depth, number] : numberAtDepth)
      {
        most = std::max(most, number);
      }
      flat += most;
    }
    const VolumeMap volumes = this->CountVoxels();
    const bool      isFlat = volumes.size() >= 3 && 4 * flat >= 3 * seen.number;
    if (isFlat || (volumes.size() >= 5 && volumes.at(label) >= 8 * ExteriorLabelDetail::MedianOfOthers(volumes, label)))
    {
      m_ExteriorLabels.push_back(label);
    }
  }
}

template <typename TLabelImage>
auto
ExteriorLabelImageCalculator<TLabelImage>::CountVoxels() const -> VolumeMap
{
  VolumeMap          volumes;
  const auto *       run = m_Image->GetBufferPointer();
  const auto * const end = run + m_Image->GetLargestPossibleRegion().GetNumberOfPixels();
  while (run != end)
  {
    const auto         pixel = *run;
    const auto * const endOfRun = std::find_if(run, end, [pixel](auto other) { return other != pixel; });
    if (pixel != 0 || m_ZeroIsCell)
    {
      volumes[static_cast<tissue::Label>(pixel)] += static_cast<SizeValueType>(endOfRun - run);
    }
    run = endOfRun;
  }
  return volumes;
}

template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::LookAlong(unsigned int axis, Sights & sights) const
{
  // A thousand lines on a side tell shares of an eighth well, and take little time in large images.
  constexpr SizeValueType pointsPerAxis = 32;

  const auto            region = m_Image->GetLargestPossibleRegion();
  const auto            size = region.GetSize();
  const unsigned int    u = (axis + 1) % 3;
  const unsigned int    v = (axis + 2) % 3;
  const OffsetValueType stride = m_Image->GetOffsetTable()[axis];
  const auto            stepOf = [&size](unsigned int i) { return (size[i] + pointsPerAxis - 1) / pointsPerAxis; };
  for (SizeValueType i = 0; i < size[u] && size[axis] > 0; i += stepOf(u))
  {
    for (SizeValueType j = 0; j < size[v]; j += stepOf(v))
    {
      auto index = region.GetIndex();
      index[u] += static_cast<IndexValueType>(i);
      index[v] += static_cast<IndexValueType>(j);
      const auto * first = m_Image->GetBufferPointer() + m_Image->ComputeOffset(index);
      const auto * last = first + stride * static_cast<OffsetValueType>(size[axis] - 1);
      this->Look(first, stride, size[axis], 2 * axis, sights);
      this->Look(last, -stride, size[axis], 2 * axis + 1, sights);
    }
  }
}

template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::Look(const typename LabelImageType::PixelType * pixel,
                                                OffsetValueType stride, SizeValueType length, unsigned int side,
                                                Sights & sights) const
{
  const auto isTransparent = [this](auto value) { return value == 0 && !m_ZeroIsCell; };
  ++sights.numberOfLines;
  sights.numberOfLinesFromZero += isTransparent(*pixel);
  SizeValueType depth = 0;
  while (depth + 1 < length && isTransparent(*pixel))
  {
    pixel += stride;
    ++depth;
  }
  if (!isTransparent(*pixel))
  {
    LabelSights & seen = sights.ofLabel[static_cast<tissue::Label>(*pixel)];
    ++seen.number;
    ++seen.numberFromSide[side];
    ++seen.numberAtDepth[side][depth];
  }
}

template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Image);
  os << indent << "ZeroIsCell: " << m_ZeroIsCell << std::endl;
  os << indent << "ExteriorLabels:";
  for (const tissue::Label label : m_ExteriorLabels)
  {
    os << ' ' << label;
  }
  os << std::endl;
}
} // namespace itk

#endif
