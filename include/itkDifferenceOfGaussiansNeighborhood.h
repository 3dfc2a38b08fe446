/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkDifferenceOfGaussiansNeighborhood_h
#define itkDifferenceOfGaussiansNeighborhood_h

#include "itkImage.h"

#include <algorithm>
#include <array>

namespace itk
{
/** \class DifferenceOfGaussiansNeighborhood
 * \brief The difference of smoothed images around a voxel, in steps of voxels and levels.
 *
 * Four images in a row, each smoothed more than the one before, make the three levels -1, 0 and 1. Beyond the border of
 * the image the difference goes on as it is on the border, as in the Gaussian filters. With the sign -1 it is that of
 * the inverse image.
 *
 * \ingroup TissueTessellation
 */
class DifferenceOfGaussiansNeighborhood
{
public:
  using ImageType = Image<float, 3>;
  using Step = std::array<int, 4>;

  DifferenceOfGaussiansNeighborhood(const std::array<ImageType::Pointer, 4> & window, const Index<3> & index,
                                    float sign = 1.0f)
    : m_Strides(window[0]->GetOffsetTable())
    , m_Sign(sign)
  {
    const auto            region = window[0]->GetBufferedRegion();
    const OffsetValueType offset = window[0]->ComputeOffset(index);
    std::transform(window.begin(), window.end(), m_Voxels.begin(), [offset](const ImageType * image) {
      return image->GetBufferPointer() + offset;
    });
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      const auto step = index[axis] - region.GetIndex(axis);
      m_IsFirst[axis] = step == 0;
      m_IsLast[axis] = step + 1 == static_cast<IndexValueType>(region.GetSize(axis));
    }
  }

  /** Tells whether a step of one leaves the image. */
  bool
  Leaves(std::size_t axis, int step) const
  {
    return (step < 0 && m_IsFirst[axis]) || (step > 0 && m_IsLast[axis]);
  }

  double
  operator()(const Step & step) const
  {
    OffsetValueType offset = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      offset += this->Leaves(axis, step[axis]) ? 0 : step[axis] * m_Strides[axis];
    }
    const auto level = static_cast<std::size_t>(1 + step[3]);
    return m_Sign * (m_Voxels[level][offset] - m_Voxels[level + 1][offset]);
  }

  /** Tells whether the middle is above its 80 neighbours. Of equal ones the first in raster order is. */
  bool
  IsMaximum() const
  {
    const double middle = (*this)({ { 0, 0, 0, 0 } });
    for (const int level : { 0, -1, 1 })
    {
      // Most voxels fail on the slope that they lie on, whatever its direction.
      for (const int i :
           { 12, 14, 10, 16, 4, 22, 0, 1, 2, 3, 5, 6, 7, 8, 9, 11, 13, 15, 17, 18, 19, 20, 21, 23, 24, 25, 26 })
      {
        const Step step{ { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1, level } };
        if ((level == 0 && i == 13) || this->Leaves(0, step[0]) || this->Leaves(1, step[1]) || this->Leaves(2, step[2]))
        {
          continue;
        }
        const double other = (*this)(step);
        const bool   isBefore = level < 0 || (level == 0 && i < 13);
        if ((isBefore ? other >= middle : other > middle))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  std::array<const float *, 4> m_Voxels{};
  const OffsetValueType *      m_Strides;
  float                        m_Sign;
  std::array<bool, 3>          m_IsFirst{};
  std::array<bool, 3>          m_IsLast{};
};
} // namespace itk

#endif
