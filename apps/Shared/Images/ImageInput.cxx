/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ImageInput.h"

#include <filesystem>
#include <stdexcept>

namespace tissue
{
itk::ImageIOBase::Pointer
OpenImage(const std::string & path)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error("a folder, not an image");
  }
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error("no such file");
  }
  const itk::ImageIOBase::Pointer io =
    itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::ImageIOFactory::IOFileModeEnum::ReadMode);
  if (!io)
  {
    throw std::runtime_error("not an image in a format that ITK reads");
  }
  io->SetFileName(path);
  io->ReadImageInformation();
  return io;
}

void
RequireVolume(const itk::ImageIOBase * io, const std::string & kind)
{
  // A trailing axis of one voxel is how some formats write fewer dimensions.
  unsigned int dimensions = io->GetNumberOfDimensions();
  while (dimensions > 1 && io->GetDimensions(dimensions - 1) == 1)
  {
    --dimensions;
  }
  if (dimensions != 3)
  {
    throw std::runtime_error("the image has " + std::to_string(dimensions) + " dimensions, " + kind + " has 3");
  }
  if (io->GetNumberOfComponents() != 1)
  {
    throw std::runtime_error("the image has " + std::to_string(io->GetNumberOfComponents()) + " components a voxel, " +
                             kind + " has 1");
  }
}
} // namespace tissue
