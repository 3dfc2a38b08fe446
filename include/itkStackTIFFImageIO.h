/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkStackTIFFImageIO_h
#define itkStackTIFFImageIO_h

#include "itkStackImageIOBase.h"

#include <memory>

namespace tissue
{
class TIFFPages;
struct StackLayout;
} // namespace tissue

namespace itk
{
/** \class StackTIFFImageIO
 * \brief Reads the 3-D images that programs of microscopy write as TIFF files.
 *
 * Pixels: integers of 1 to 64 bits, signed or not, and floats of 32 and 64; strips or tiles; each compression that
 * libtiff has; both byte orders; BigTIFF. The numbers of the file are read as they are: a palette is not applied, as
 * its indices are the labels. Colours (RGB and others) are refused, several samples of a grey pixel are channels.
 *
 * The pages are the slices, unless the file tells of channels and frames: ImageJ's and Fiji's description (also their
 * stacks above 4 GiB, which have one page alone), that of tifffile and scikit-image, and OME-XML. See StackImageIOBase
 * for how one is chosen. Frames of a single slice are refused, as none is an image of three dimensions.
 *
 * The size of a voxel is OME's physical size, or else that of the resolution tags in the unit that ImageJ names, with
 * its spacing for the distance of slices, or in that of the tags. A whole number of dots an inch up to 1200 is a
 * resolution for print, which tells nothing. ITK's own files, known by their tag Software, have ITK's numbers.
 *
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT StackTIFFImageIO : public StackImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StackTIFFImageIO);

  using Self = StackTIFFImageIO;
  using Superclass = StackImageIOBase;
  using Pointer = SmartPointer<Self>;

  itkNewMacro(Self);
  itkTypeMacro(StackTIFFImageIO, StackImageIOBase);

  bool
  CanReadFile(const char * path) override;
  void
  ReadImageInformation() override;
  void
  Read(void * buffer) override;

protected:
  StackTIFFImageIO();
  ~StackTIFFImageIO() override;

private:
  void
  ReadLayout();

  std::unique_ptr<tissue::TIFFPages>   m_Pages;
  std::unique_ptr<tissue::StackLayout> m_Layout;
};
} // namespace itk

#endif
