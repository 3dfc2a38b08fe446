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
#include <vector>

namespace tissue
{
using ScalarImage = itk::Image<float, 3>;

struct ScalarImageFile
{
  ScalarImage::Pointer image;
  /** Of the file. */
  std::string              pixelType;
  std::vector<std::string> warnings;
};

/** Reads an image of a stain, of any type of voxels; `spacing` in place of the file's.
 * \throws FileError: no such file, not readable, cut off, not three-dimensional, more than one component. */
ScalarImageFile
ReadScalarImage(const std::string & path, const std::optional<std::array<double, 3>> & spacing = std::nullopt);
} // namespace tissue

#endif
