/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ImageInput_h
#define ImageInput_h

#include "Shared/Images/ImageOptions.h"

#include <itkImageFileReader.h>
#include <itkImageIOBase.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace tissue
{
/** What the numbers of an image are. */
enum class ImageKind
{
  Labels,
  Stain
};

/** Whether there is a reader for a file, of ITK's or of our own, by its first bytes or its name. Throws as
 * RequireSoundHeader(). */
bool
IsImageFile(const std::string & path);

/** \brief The header of an image file: of any of ITK's formats, or of TIFF, HDF5 and Inrimage by readers of our own.
 *
 * "FILE:/NAME" is a data set of HDF5; without a name the only one of integers is preferred for labels.
 * \throws std::runtime_error or itk::ExceptionObject: a folder, no such file, not an image, several channels or frames
 * of which none is chosen, or one is that there is not. */
itk::ImageIOBase::Pointer
OpenImage(const std::string & path, const ImageOptions & options, ImageKind kind);

/** Throws std::runtime_error where the image, by its header, has not three dimensions or several components a voxel.
 * \param kind what it should be, as "a label image". */
void
RequireVolume(const itk::ImageIOBase * io, const std::string & kind);

/** The unit of the lengths in an image that ReadImage() or ReadBox() has read, "micrometres" or "millimetres"; empty
 * where it is not known. */
std::string
FindUnit(const itk::ImageIOBase * io, const ImageOptions & options);

/** Whether the voxels are integers times a factor that the header tells, scl_slope of NIfTI: they are read as floats.
 */
bool
IsScaled(const itk::ImageIOBase * io);

/** What is to be said of the header: of the size of the voxels, where the file does not tell it, of its unit, and of
 * how the file was understood; a sentence each. */
std::vector<std::string>
FindHeaderWarnings(const itk::ImageIOBase * io, const ImageOptions & options);

/** \brief Gives an image that was read through `io` the voxel size of the options, or its own in the file's unit.
 *
 * ITK turns the micrometres of NIfTI into millimetres: they become micrometres again. */
void
ApplyVoxelSize(const itk::ImageIOBase * io, const ImageOptions & options, itk::ImageBase<3> * image);

/** What a reader does; an exception that is none of the language's, as HDF5 has them, becomes a std::runtime_error. */
template <typename TWork>
void
ByReader(const TWork & work)
{
  try
  {
    work();
  }
  catch (const std::exception &)
  {
    throw;
  }
  catch (...)
  {
    throw std::runtime_error("the file is cut off or broken: its reader gives up");
  }
}

/** The image of a file that OpenImage() has opened. */
template <typename TImage>
typename TImage::Pointer
ReadImage(itk::ImageIOBase * io, const ImageOptions & options)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetImageIO(io);
  reader->SetFileName(io->GetFileName());
  ByReader([&reader] { reader->Update(); });
  typename TImage::Pointer image = reader->GetOutput();
  image->DisconnectPipeline();
  ApplyVoxelSize(io, options, image);
  return image;
}

/** An image without pixels that fills the box of a file's. */
itk::ImageBase<3>::Pointer
ReadBox(itk::ImageIOBase * io, const ImageOptions & options);
} // namespace tissue

#endif
