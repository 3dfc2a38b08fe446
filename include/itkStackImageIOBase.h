/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkStackImageIOBase_h
#define itkStackImageIOBase_h

#include "TissueTessellationExport.h"
#include "itkImageIOBase.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace itk
{
/** \class StackImageIOBase
 * \brief Base of the readers of 3-D images from files of microscopy, which may hold several channels and frames.
 *
 * What is read is always one stack of one component: of a file of several channels or frames one must be chosen, else
 * ReadImageInformation() throws an exception that says how many there are. Both are counted from 1 on, as Fiji does.
 * Of a file of a single one it is read whatever is chosen.
 *
 * Lengths are micrometres where the file tells their unit, and as they are in the file otherwise.
 *
 * Regions are read on their own (CanStreamRead()), at the cost of their slices. These classes write nothing.
 *
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT StackImageIOBase : public ImageIOBase
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(StackImageIOBase);

  using Self = StackImageIOBase;
  using Superclass = ImageIOBase;
  using Pointer = SmartPointer<Self>;

  itkTypeMacro(StackImageIOBase, ImageIOBase);

  /** The channel and the frame to read, 1 and above; the default, 0, is none. */
  itkSetMacro(Channel, unsigned int);
  itkGetConstMacro(Channel, unsigned int);
  itkSetMacro(Frame, unsigned int);
  itkGetConstMacro(Frame, unsigned int);

  /** What the file has; known as soon as ReadImageInformation() has returned or has thrown for want of a choice. */
  itkGetConstMacro(NumberOfChannels, unsigned int);
  itkGetConstMacro(NumberOfFrames, unsigned int);

  /** Whether the file tells the size of a voxel along an axis; where it does not, it is taken for 1. */
  bool
  HasSpacing(unsigned int axis) const
  {
    return m_VoxelSize[axis].has_value();
  }

  /** Whether the lengths that the file tells are known to be micrometres. */
  itkGetConstMacro(IsInMicrometers, bool);

  /** What is to be known of how the file was understood; a sentence each. */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }

  bool
  SupportsDimension(unsigned long dimension) override
  {
    return dimension == 3;
  }
  bool
  CanStreamRead() override
  {
    return true;
  }
  ImageIORegion
  GenerateStreamableReadRegionFromRequestedRegion(const ImageIORegion & requested) const override
  {
    return requested;
  }

  bool
  CanWriteFile(const char *) override
  {
    return false;
  }
  void
  WriteImageInformation() override;
  void
  Write(const void * buffer) override;

protected:
  StackImageIOBase();
  ~StackImageIOBase() override = default;

  /** Forgets what is known of another file. */
  void
  Reset();

  /** \throws ExceptionObject where one of several is to be chosen, or is chosen that there is not. */
  void
  RequireChoice(unsigned int numberOfChannels, unsigned int numberOfFrames);

  /** The numbers, from 0 on, of what is chosen. */
  unsigned int
  ChosenChannel() const;
  unsigned int
  ChosenFrame() const;

  /** What the reader knows of the file, in terms of ImageIOBase. Sizes that are not told, nor positive, become 1. */
  void
  SetStack(const std::array<SizeValueType, 3> & size, const std::array<std::optional<double>, 3> & voxelSize,
           bool isInMicrometers, IOComponentEnum componentType);

  void
  AddWarning(const std::string & warning)
  {
    m_Warnings.push_back(warning);
  }

private:
  unsigned int                         m_Channel = 0;
  unsigned int                         m_Frame = 0;
  unsigned int                         m_NumberOfChannels = 1;
  unsigned int                         m_NumberOfFrames = 1;
  std::array<std::optional<double>, 3> m_VoxelSize;
  bool                                 m_IsInMicrometers = false;
  std::vector<std::string>             m_Warnings;
};
} // namespace itk

#endif
