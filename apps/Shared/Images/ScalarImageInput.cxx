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
ReadScalarImage(const std::string & path, const ImageOptions & options)
{
  return WithFileName(path, [&] {
    StandardErrorCapture            messages;
    const itk::ImageIOBase::Pointer io = OpenImage(path, options, ImageKind::Stain);
    RequireVolume(io, "an image of a stain");
    RequireAllVoxels(path, io);
    ScalarImageFile file;
    file.image = ReadImage<ScalarImage>(io, options);
    file.pixelType = itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType());
    file.unit = FindUnit(io, options);
    file.warnings = JudgeMessages(messages.Release(), io);
    for (const std::string & warning : FindHeaderWarnings(io, options))
    {
      file.warnings.push_back(warning);
    }
    return file;
  });
}
} // namespace tissue
