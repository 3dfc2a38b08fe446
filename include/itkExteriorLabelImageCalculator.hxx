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

namespace itk
{
template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::Compute()
{
  static_assert(LabelImageType::ImageDimension == 3, "A tissue is an image in three dimensions.");

  Sights sights;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    this->LookAlong(axis, sights);
  }
  tissue::Label candidate = 0;
  SizeValueType most = 0;
  SizeValueType second = 0;
  SizeValueType total = 0;
  for (const auto & [label, number] : sights.numberByLabel)
  {
    total += number;
    second = std::max(second, std::min(most, number));
    candidate = number > most ? label : candidate;
    most = std::max(most, number);
  }
  const bool isPadded = 2 * sights.numberOfLinesFromZero > sights.numberOfLines;
  const bool dominates = isPadded ? 20 * most >= 19 * total : 8 * most >= sights.numberOfLines && most >= 4 * second;
  m_HasExteriorLabel = candidate != 0 && dominates;
  m_ExteriorLabel = m_HasExteriorLabel ? candidate : 0;
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
      this->Look(first, stride, size[axis], sights);
      this->Look(first + stride * static_cast<OffsetValueType>(size[axis] - 1), -stride, size[axis], sights);
    }
  }
}

template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::Look(const typename LabelImageType::PixelType * pixel,
                                                OffsetValueType stride, SizeValueType length, Sights & sights) const
{
  const auto isTransparent = [this](auto value) { return value == 0 && !m_ZeroIsCell; };
  ++sights.numberOfLines;
  sights.numberOfLinesFromZero += isTransparent(*pixel);
  while (length > 1 && isTransparent(*pixel))
  {
    pixel += stride;
    --length;
  }
  if (!isTransparent(*pixel))
  {
    ++sights.numberByLabel[static_cast<tissue::Label>(*pixel)];
  }
}

template <typename TLabelImage>
void
ExteriorLabelImageCalculator<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  itkPrintSelfObjectMacro(Image);
  os << indent << "ZeroIsCell: " << m_ZeroIsCell << std::endl;
  os << indent << "HasExteriorLabel: " << m_HasExteriorLabel << std::endl;
  os << indent << "ExteriorLabel: " << m_ExteriorLabel << std::endl;
}
} // namespace itk

#endif
