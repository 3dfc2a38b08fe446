/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "ScalarImageInput.h"

#include "ImageFileCheck.h"
#include "RunProgram.h"
#include "StandardErrorCapture.h"

#include <itkImageFileReader.h>

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
    RequireThreeDimensions(io, "a stack");
    RequireAllVoxels(path, io);
    const auto reader = itk::ImageFileReader<ScalarImage>::New();
    reader->SetFileName(path);
    reader->Update();
    JudgeMessages(messages.Release(), io);
    const ScalarImage::Pointer image = reader->GetOutput();
    image->DisconnectPipeline();
    if (spacing)
    {
      image->SetSpacing(spacing->data());
    }
    return image;
  }
  catch (const std::exception & error)
  {
    throw std::runtime_error(path + ": " + ToMessage(error));
  }
}
} // namespace tissue
