/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ScalarImageInput.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Images/ImageFileCheck.h"
#include "Shared/Images/ImageInput.h"
#include "Shared/Images/StandardErrorCapture.h"

namespace tissue
{
ScalarImageFile
ReadScalarImage(const std::string & path, const std::optional<std::array<double, 3>> & spacing)
{
  return WithFileName(path, [&] {
    StandardErrorCapture            messages;
    const itk::ImageIOBase::Pointer io = OpenImage(path);
    RequireVolume(io, "an image of a stain");
    RequireAllVoxels(path, io);
    ScalarImageFile file;
    file.image = ReadImage<ScalarImage>(path, spacing);
    file.pixelType = itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType());
    file.warnings = JudgeMessages(messages.Release(), io);
    return file;
  });
}
} // namespace tissue
