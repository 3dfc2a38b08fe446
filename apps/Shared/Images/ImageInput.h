/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ImageInput_h
#define ImageInput_h

#include <itkChangeInformationImageFilter.h>
#include <itkImageFileReader.h>
#include <itkImageIOBase.h>

#include <array>
#include <optional>
#include <string>

namespace tissue
{
/** The header of an image file.
 * \throws std::runtime_error or itk::ExceptionObject: a folder, no such file, not an image. */
itk::ImageIOBase::Pointer
OpenImage(const std::string & path);

/** Throws std::runtime_error where the image, by its header, has not three dimensions or several components a voxel.
 * \param kind what it should be, as "a label image". */
void
RequireVolume(const itk::ImageIOBase * io, const std::string & kind);

/** The image of a file, with another voxel size if there is one. */
template <typename TImage>
typename TImage::Pointer
ReadImage(const std::string & path, const std::optional<std::array<double, 3>> & spacing)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetFileName(path);
  const auto information = itk::ChangeInformationImageFilter<TImage>::New();
  information->SetInput(reader->GetOutput());
  if (spacing)
  {
    information->ChangeSpacingOn();
    information->SetOutputSpacing(itk::Vector<double, 3>(spacing->data()));
  }
  information->Update();
  typename TImage::Pointer image = information->GetOutput();
  image->DisconnectPipeline();
  return image;
}
} // namespace tissue

#endif
