/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/WholeNumbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** Throws for the voxel at a place in the buffer. */
template <typename TPixel>
[[noreturn]] void
Refuse(const itk::Image<TPixel, 3> * image, std::ptrdiff_t place, bool isScaled, bool isTooLarge)
{
  const auto         index = image->ComputeIndex(place);
  std::ostringstream text;
  text.precision(std::numeric_limits<TPixel>::max_digits10);
  text << "the voxel at index (" << index[0] << ", " << index[1] << ", " << index[2] << ") has the value "
       << image->GetBufferPointer()[place];
  if (isTooLarge)
  {
    text << ", beyond the whole numbers that floats of " << 8 * sizeof(TPixel) << " bits hold one by one (2^"
         << std::numeric_limits<TPixel>::digits << ")";
  }
  else
  {
    text << ", which is no whole number; labels are whole numbers";
  }
  text << (isScaled ? " (the file is scaled by scl_slope: its integers times a factor)" : "");
  throw std::runtime_error(text.str());
}
} // namespace

template <typename TPixel>
WholeNumberImage::Pointer
ToWholeNumbers(const itk::Image<TPixel, 3> * image, bool isScaled)
{
  constexpr double scaled = 1e-3;
  const TPixel     most = std::ldexp(TPixel{ 1 }, std::numeric_limits<TPixel>::digits);
  const auto       labels = WholeNumberImage::New();
  labels->CopyInformation(image);
  labels->SetRegions(image->GetBufferedRegion());
  labels->Allocate();
  const TPixel * const from = image->GetBufferPointer();
  long long * const    to = labels->GetBufferPointer();
  const auto           number = static_cast<std::ptrdiff_t>(image->GetBufferedRegion().GetNumberOfPixels());
  for (std::ptrdiff_t i = 0; i < number; ++i)
  {
    const double value = from[i];
    const double whole = std::round(value);
    const double tolerance = isScaled ? std::max(scaled, std::abs(value) * std::numeric_limits<float>::epsilon()) : 0.0;
    // A value that is no number is within no distance.
    if (!(std::abs(value - whole) <= tolerance))
    {
      Refuse(image, i, isScaled, false);
    }
    if (std::abs(whole) > most)
    {
      Refuse(image, i, isScaled, true);
    }
    to[i] = static_cast<long long>(whole);
  }
  return labels;
}

template WholeNumberImage::Pointer
ToWholeNumbers(const itk::Image<float, 3> *, bool);
template WholeNumberImage::Pointer
ToWholeNumbers(const itk::Image<double, 3> *, bool);
} // namespace tissue
