/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ImageHeaderCheck.h"

#include "Shared/Files/ImageDataFiles.h"
#include "Shared/Images/MetaImageHeader.h"
#include "Shared/Images/NiftiHeader.h"
#include "Shared/Images/NrrdHeader.h"
#include "Shared/Images/VoxelFiles.h"

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
namespace fs = std::filesystem;

/** Whether the format compresses, if at all, by deflate. */
bool
IsDeflatedAtMost(const itk::ImageIOBase * io)
{
  static const std::set<std::string> formats{ "MetaImageIO", "NrrdImageIO", "NiftiImageIO", "GiplImageIO",
                                              "MRCImageIO",  "VTKImageIO",  "InrImageIO",   "BioRadImageIO" };
  return formats.count(io->GetNameOfClass()) > 0;
}

void
RequireVoxelsInFile(const std::string & path, const itk::ImageIOBase * io)
{
  VoxelFiles voxels;
  voxels.encoding = VoxelEncoding::Compressed;
  voxels.bytesOfNumber = io->GetComponentSize();
  voxels.Multiply(io->GetNumberOfComponents());
  for (unsigned int axis = 0; axis < io->GetNumberOfDimensions(); ++axis)
  {
    voxels.Multiply(io->GetDimensions(axis));
  }
  voxels.files = { path };
  for (const std::string & file : FindImageDataFiles(path))
  {
    std::error_code error;
    fs::is_regular_file(file, error) ? voxels.files.emplace_back(file) : fs::path();
  }
  RequireVoxels(voxels);
}

bool
IsSoundSpacing(double spacing)
{
  return spacing >= 1e-12 && spacing <= 1e12;
}

/** Beyond these the voxels of an image have no places of their own. */
void
RequireSoundPlace(const itk::ImageIOBase * io, unsigned int axis)
{
  constexpr double mostVoxels = 1e9;
  constexpr double most = 1e12;
  const double     origin = std::abs(io->GetOrigin(axis));
  bool             isSound = origin <= most && !(origin > mostVoxels * std::abs(io->GetSpacing(axis)));
  for (const double component : io->GetDirection(axis))
  {
    isSound = isSound && std::abs(component) <= 2.0;
  }
  if (!isSound)
  {
    std::ostringstream text;
    text << "the header has an origin, " << io->GetOrigin(axis) << " along axis " << axis
         << ", or a direction that no image can have: at most 1e+12, and 1e+09 voxels, and unit vectors";
    throw std::runtime_error(text.str());
  }
}
} // namespace

void
RequireSoundHeader(const std::string & path)
{
  if (!fs::is_regular_file(path))
  {
    throw std::runtime_error("not a regular file");
  }
  if (IsNrrd(path))
  {
    RequireSoundNrrd(path);
  }
  else if (IsMetaImage(path))
  {
    RequireSoundMetaImage(path);
  }
  else
  {
    RequireSoundNifti(path);
  }
}

void
RequireSoundGeometry(const std::string & path, const itk::ImageIOBase * io, bool hasOwnSpacing)
{
  for (unsigned int axis = 0; axis < io->GetNumberOfDimensions(); ++axis)
  {
    if (io->GetDimensions(axis) == 0)
    {
      throw std::runtime_error("the header has no voxel along axis " + std::to_string(axis));
    }
    if (!hasOwnSpacing && axis < 3 && !IsSoundSpacing(io->GetSpacing(axis)))
    {
      std::ostringstream text;
      text << "the header has voxels of size " << io->GetSpacing(axis) << " along axis " << axis
           << ", must be in 1e-12 .. 1e+12; --spacing X Y Z gives the voxel size";
      throw std::runtime_error(text.str());
    }
    RequireSoundPlace(io, axis);
  }
  if (IsDeflatedAtMost(io))
  {
    RequireVoxelsInFile(path, io);
  }
}
} // namespace tissue
