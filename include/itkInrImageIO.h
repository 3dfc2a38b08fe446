/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkInrImageIO_h
#define itkInrImageIO_h

#include "itkStackImageIOBase.h"

namespace itk
{
/** \class InrImageIO
 * \brief Reads images of Inrimage (.inr, .inr.gz), the format of MARS and openalea.
 *
 * The header is text in blocks of 256 bytes that ends in "##}"; of it XDIM, YDIM, ZDIM, VDIM, TYPE, PIXSIZE, CPU and
 * VX, VY, VZ are taken. VX, VY and VZ are micrometres, as MARS and openalea have it. Pixels: integers of 8 to 64 bits
 * and floats of 32 and 64, either byte order; gzipped or not. Of several components of a voxel (VDIM) each is a
 * channel. SCALE, of fixed-point numbers, is not applied, as no program does: a label is the integer itself.
 *
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT InrImageIO : public StackImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(InrImageIO);

  using Self = InrImageIO;
  using Superclass = StackImageIOBase;
  using Pointer = SmartPointer<Self>;

  itkNewMacro(Self);
  itkTypeMacro(InrImageIO, StackImageIOBase);

  bool
  CanReadFile(const char * path) override;
  void
  ReadImageInformation() override;
  void
  Read(void * buffer) override;

protected:
  InrImageIO();
  ~InrImageIO() override = default;

private:
  std::size_t m_HeaderSize = 0;
};
} // namespace itk

#endif
