/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "ScalarImageInput.h"

#include "ImageFileCheck.h"
#include "ImageInput.h"
#include "RunProgram.h"
#include "StandardErrorCapture.h"

#include <stdexcept>

namespace tissue
{
ScalarImage::Pointer
ReadScalarImage(const std::string & path, const std::optional<std::array<double, 3>> & spacing)
{
  try
  {
    StandardErrorCapture            messages;
    const itk::ImageIOBase::Pointer io = OpenImage(path);
    RequireVolume(io, "an image of a stain");
    RequireAllVoxels(path, io);
    const ScalarImage::Pointer image = ReadImage<ScalarImage>(path, spacing);
    JudgeMessages(messages.Release(), io);
    return image;
  }
  catch (const std::exception & error)
  {
    throw std::runtime_error(path + ": " + ToMessage(error));
  }
}
} // namespace tissue
