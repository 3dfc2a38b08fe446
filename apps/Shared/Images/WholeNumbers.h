/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WholeNumbers_h
#define WholeNumbers_h

#include <itkImage.h>

#include <string>

namespace tissue
{
/** What labels of an image of floats become. */
using WholeNumberImage = itk::Image<long long, 3>;

/** \brief The labels of an image of floats whose values are whole numbers.
 *
 * Refused are, in the order of the voxels: values that are not whole (NaN and infinities among them), and those beyond
 * the numbers that the type holds one by one (2^24 of float, 2^53 of double). \param isScaled whether the file holds
 * integers and a factor: values are then whole within 1e-3, and within the rounding of single precision, and the
 * message says so. \throws std::runtime_error with the first such value and its index. */
template <typename TPixel>
WholeNumberImage::Pointer
ToWholeNumbers(const itk::Image<TPixel, 3> * image, bool isScaled);
} // namespace tissue

#endif
