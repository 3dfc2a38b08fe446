/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ScalarImageInput_h
#define ScalarImageInput_h

#include <itkImage.h>

#include <array>
#include <optional>
#include <string>

namespace tissue
{
using ScalarImage = itk::Image<float, 3>;

/** Reads an image of a stain, of any type of voxels; `spacing` in place of the file's.
 * \throws std::runtime_error or itk::ExceptionObject that names the file: none of that name, not readable, cut off, not
 * three-dimensional, more than one component. */
ScalarImage::Pointer
ReadScalarImage(const std::string & path, const std::optional<std::array<double, 3>> & spacing);
} // namespace tissue

#endif
