/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ImageInput.h"

#include "Shared/Images/ChosenStackImageIO.h"
#include "Shared/Images/ImageHeaderCheck.h"
#include "itkStackHDF5ImageIO.h"
#include "itkStackImageIOFactory.h"

#include <itkMetaDataObject.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
constexpr double micrometersOfMillimeter = 1000.0;

const itk::StackImageIOBase *
AsStack(const itk::ImageIOBase * io)
{
  return dynamic_cast<const itk::StackImageIOBase *>(io);
}

/** A field of NIfTI's header; 0 where the image is of another format. */
double
FieldOfNifti(const itk::ImageIOBase * io, const std::string & name)
{
  std::string value;
  const bool  isNifti = SourceOf(io)->GetNameOfClass() == std::string("NiftiImageIO");
  return isNifti && itk::ExposeMetaData<std::string>(io->GetMetaDataDictionary(), name, value)
           ? std::strtod(value.c_str(), nullptr)
           : 0.0;
}

/** The unit of NIfTI's header: 1 metre, 2 millimetre, 3 micrometre, 0 where it has none, or is of another format. */
int
UnitOfNifti(const itk::ImageIOBase * io)
{
  constexpr int spatial = 7;
  return static_cast<int>(FieldOfNifti(io, "xyzt_units")) & spatial;
}

bool
HasVoxelSize(const itk::ImageIOBase * io)
{
  const itk::StackImageIOBase * const stack = AsStack(io);
  return stack ? stack->HasSpacing(0) && stack->HasSpacing(1) && stack->HasSpacing(2) : !AreAllOnes(io);
}

bool
UsesSpacingOf(const ImageOptions & options, const itk::ImageIOBase * io)
{
  return options.spacing && !(options.isOptional && HasVoxelSize(io));
}

/** Null where there is none. */
itk::ImageIOBase::Pointer
FindReader(const std::string & path)
{
  itk::StackImageIOFactory::RegisterOneFactory();
  return itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::ImageIOFactory::IOFileModeEnum::ReadMode);
}

void
RequireFile(const std::string & path)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error("a folder, not an image");
  }
  const std::string file = itk::StackHDF5ImageIO::SplitPath(path).first;
  if (!std::filesystem::exists(file))
  {
    throw std::runtime_error("no such file");
  }
  RequireSoundHeader(file);
}

/** Throws where the options choose of a file what it has not. */
void
RequireChannelAndFrame(const itk::ImageIOBase * io, const ImageOptions & options)
{
  const itk::StackImageIOBase * const stack = AsStack(io);
  const auto require = [&options](const char * name, unsigned int chosen, unsigned int number) {
    if ((!options.isOptional || options.requiresChoice) && chosen > number)
    {
      throw std::runtime_error("the file has " + std::to_string(number) + " " + name + (number == 1 ? "" : "s") +
                               ", there is no " + name + " " + std::to_string(chosen));
    }
  };
  require("channel", options.channel, stack ? stack->GetNumberOfChannels() : 1);
  require("frame", options.frame, stack ? stack->GetNumberOfFrames() : 1);
}

/** Throws where the file has several channels or frames and the options choose none. */
void
RequireChoice(const itk::ImageIOBase * io, const ImageOptions & options)
{
  const itk::StackImageIOBase * const stack = AsStack(io);
  std::string                         text;
  const auto add = [&text](const char * name, unsigned int chosen, unsigned int number, const std::string & option) {
    if (chosen == 0 && number > 1)
    {
      text += (text.empty() ? "the file has " : ", and ") + std::to_string(number) + " " + name +
              ", of which one is read: " + option + " 1 to " + std::to_string(number) + " chooses it";
    }
  };
  if (stack != nullptr)
  {
    add("channels", options.channel, stack->GetNumberOfChannels(), options.channelOption);
    add("frames", options.frame, stack->GetNumberOfFrames(), options.frameOption);
  }
  if (!text.empty())
  {
    throw std::runtime_error(text);
  }
}

/** \throws std::runtime_error where a choice is missing that the options could make. */
void
ReadHeader(itk::ImageIOBase * io, const ImageOptions & options)
{
  try
  {
    ByReader([io] { io->ReadImageInformation(); });
  }
  catch (const itk::ExceptionObject &)
  {
    RequireChoice(io, options);
    throw;
  }
}

/** How many layers a segmentation of 3D Slicer has; 0 for another image. */
unsigned int
CountSegmentationLayers(const itk::ImageIOBase * io)
{
  std::string                     segment;
  const itk::MetaDataDictionary & dictionary = io->GetMetaDataDictionary();
  const bool                      isSegmentation = itk::ExposeMetaData(dictionary, "Segment0_ID", segment) ||
                              itk::ExposeMetaData(dictionary, "Segment0_Name", segment) ||
                              std::string(io->GetFileName()).find(".seg.nrrd") != std::string::npos;
  return isSegmentation ? io->GetNumberOfComponents() : 0;
}

/** The reader itself where it reads one stack, or one that reads the stack that the options choose. */
itk::ImageIOBase::Pointer
ChooseStack(itk::ImageIOBase * io, const ImageOptions & options)
{
  const unsigned int layers = CountSegmentationLayers(io);
  if (layers > 1 && options.channel == 0)
  {
    throw std::runtime_error("the file is a segmentation of " + std::to_string(layers) +
                             " layers (3D Slicer), whose segments overlap, and one is read: " + options.channelOption +
                             " 1 to " + std::to_string(layers) +
                             " chooses it, or Slicer exports the segments as a labelmap, or collapses the layers");
  }
  if (AsStack(io) != nullptr || !ChosenStackImageIO::IsFor(io))
  {
    return io;
  }
  const auto stack = ChosenStackImageIO::New();
  stack->SetSource(io);
  stack->SetChannel(options.channel);
  stack->SetFrame(options.frame);
  stack->SetFileName(io->GetFileName());
  ReadHeader(stack, options);
  return stack.GetPointer();
}
} // namespace

bool
IsImageFile(const std::string & path)
{
  RequireSoundHeader(itk::StackHDF5ImageIO::SplitPath(path).first);
  return FindReader(path).IsNotNull();
}

itk::ImageIOBase::Pointer
OpenImage(const std::string & path, const ImageOptions & options, ImageKind kind)
{
  RequireFile(path);
  const itk::ImageIOBase::Pointer io = FindReader(path);
  if (!io)
  {
    throw std::runtime_error("not an image in a format that ITK reads, nor one of HDF5 (FILE.h5:/NAME) or "
                             "Inrimage (.inr, .inr.gz)");
  }
  if (auto * const stack = dynamic_cast<itk::StackImageIOBase *>(io.GetPointer()))
  {
    stack->SetChannel(options.channel);
    stack->SetFrame(options.frame);
  }
  if (auto * const hdf5 = dynamic_cast<itk::StackHDF5ImageIO *>(io.GetPointer()))
  {
    hdf5->SetPrefersIntegers(kind == ImageKind::Labels);
  }
  io->SetFileName(path);
  ReadHeader(io, options);
  RequireSoundGeometry(path, io, options.spacing.has_value());
  const itk::ImageIOBase::Pointer chosen = ChooseStack(io, options);
  RequireChannelAndFrame(chosen, options);
  return chosen;
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

std::string
FindUnit(const itk::ImageIOBase * io, const ImageOptions & options)
{
  const itk::StackImageIOBase * const stack = AsStack(io);
  const int                           nifti = UnitOfNifti(io);
  if (UsesSpacingOf(options, io))
  {
    return {};
  }
  return (stack && stack->GetIsInMicrometers()) || nifti == 3 ? "micrometres" : nifti > 0 ? "millimetres" : "";
}

bool
IsScaled(const itk::ImageIOBase * io)
{
  const double slope = FieldOfNifti(io, "scl_slope");
  return slope != 0.0 && (slope != 1.0 || FieldOfNifti(io, "scl_inter") != 0.0);
}

std::vector<std::string>
FindHeaderWarnings(const itk::ImageIOBase * io, const ImageOptions & options)
{
  const itk::StackImageIOBase * const stack = AsStack(io);
  std::vector<std::string>            warnings = stack ? stack->GetWarnings() : std::vector<std::string>();
  if (UsesSpacingOf(options, io))
  {
    return warnings;
  }
  const std::string remedy = "--spacing X Y Z gives the voxel size";
  if (AreAllOnes(io) && !(stack && HasVoxelSize(io)))
  {
    warnings.push_back("the voxels are exactly 1 x 1 x 1: the file may have lost its voxel size, which shapes and "
                       "volumes depend on; " +
                       remedy);
  }
  else if (stack && !stack->HasSpacing(2))
  {
    warnings.push_back("the file tells no distance of its slices, which is taken for 1; " + remedy);
  }
  else if (stack && io->GetSpacing(0) == 1.0 && io->GetSpacing(1) == 1.0 && io->GetSpacing(2) != 1.0)
  {
    warnings.push_back("the voxels are exactly 1 x 1 within a slice: the file may have lost their size; " + remedy);
  }
  if (UnitOfNifti(io) == 3)
  {
    std::ostringstream text;
    text
      << "the NIfTI file is in micrometres, and so is all that is made of it: programs of ITK, as 3D Slicer, take its "
         "voxels for "
      << io->GetSpacing(0) << " x " << io->GetSpacing(1) << " x " << io->GetSpacing(2) << " millimetres";
    warnings.push_back(text.str());
  }
  return warnings;
}

void
ApplyVoxelSize(const itk::ImageIOBase * io, const ImageOptions & options, itk::ImageBase<3> * image)
{
  if (UnitOfNifti(io) == 3)
  {
    auto origin = image->GetOrigin();
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      origin[axis] *= micrometersOfMillimeter;
    }
    image->SetOrigin(origin);
    image->SetSpacing(image->GetSpacing() * micrometersOfMillimeter);
  }
  if (UsesSpacingOf(options, io))
  {
    image->SetSpacing(options.spacing->data());
  }
}

itk::ImageBase<3>::Pointer
ReadBox(itk::ImageIOBase * io, const ImageOptions & options)
{
  const auto reader = itk::ImageFileReader<itk::Image<float, 3>>::New();
  reader->SetImageIO(io);
  reader->SetFileName(io->GetFileName());
  reader->UpdateOutputInformation();
  const auto box = itk::ImageBase<3>::New();
  box->CopyInformation(reader->GetOutput());
  ApplyVoxelSize(io, options, box);
  return box;
}
} // namespace tissue
