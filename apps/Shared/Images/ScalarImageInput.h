/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ScalarImageInput_h
#define ScalarImageInput_h

#include "Shared/Images/ImageOptions.h"

#include <itkImage.h>

#include <string>
#include <vector>

namespace tissue
{
using ScalarImage = itk::Image<float, 3>;

struct ScalarImageFile
{
  ScalarImage::Pointer image;
  /** Of the file. */
  std::string pixelType;
  /** Of its lengths; empty: not known. */
  std::string              unit;
  std::vector<std::string> warnings;
};

/** Reads an image of a stain, of any type of voxels.
 * \throws FileError: as OpenImage(), cut off, not three-dimensional, more than one component. */
ScalarImageFile
ReadScalarImage(const std::string & path, const ImageOptions & options);
} // namespace tissue

#endif
