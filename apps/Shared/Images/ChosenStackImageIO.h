/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ChosenStackImageIO_h
#define ChosenStackImageIO_h

#include "itkStackImageIOBase.h"

namespace tissue
{
/** \brief Reads one stack through the reader of any format: of one component of its voxels, the channel, and one step
 * of its fourth axis, the frame.
 *
 * The whole frame is read, and the whole file where its reader cannot read parts. */
class ChosenStackImageIO : public itk::StackImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ChosenStackImageIO);

  using Self = ChosenStackImageIO;
  using Superclass = itk::StackImageIOBase;
  using Pointer = itk::SmartPointer<Self>;

  itkNewMacro(Self);
  itkTypeMacro(ChosenStackImageIO, StackImageIOBase);

  /** Whether an image, by its header, has several channels or frames, and all of its frames have three dimensions. */
  static bool
  IsFor(const itk::ImageIOBase * source);

  /** The reader, whose header has been read. */
  itkSetObjectMacro(Source, itk::ImageIOBase);
  itkGetConstObjectMacro(Source, itk::ImageIOBase);

  bool
  CanReadFile(const char *) override
  {
    return false;
  }
  bool
  CanStreamRead() override
  {
    return false;
  }
  void
  ReadImageInformation() override;
  void
  Read(void * buffer) override;

protected:
  ChosenStackImageIO() = default;
  ~ChosenStackImageIO() override = default;

private:
  itk::ImageIOBase::Pointer m_Source;
};

/** Whether the voxels are 1 x 1 x 1, as most formats hold where they know no size. Some hold the inverse of the
 * spacing, in single precision. */
bool
AreAllOnes(const itk::ImageIOBase * io);

/** The reader behind a ChosenStackImageIO, or `io` itself. */
const itk::ImageIOBase *
SourceOf(const itk::ImageIOBase * io);
} // namespace tissue

#endif
