/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkStackImageIOBase.h"

#include <cmath>

namespace itk
{
namespace
{
/** Why what is chosen of several channels or frames cannot be read; empty where it can. */
std::string
RefuseChoice(unsigned int number, unsigned int chosen, const std::string & name)
{
  if (number <= 1 || (chosen > 0 && chosen <= number))
  {
    return {};
  }
  const std::string there = "the file has " + std::to_string(number) + " " + name + "s";
  return chosen == 0 ? there + ", of which one must be chosen"
                     : there + ", there is no " + name + " " + std::to_string(chosen);
}
} // namespace

StackImageIOBase::StackImageIOBase()
{
  this->SetNumberOfDimensions(3);
  this->SetNumberOfComponents(1);
  this->SetPixelType(IOPixelEnum::SCALAR);
}

void
StackImageIOBase::WriteImageInformation()
{
  itkExceptionMacro("files of this kind are read only");
}

void
StackImageIOBase::Write(const void *)
{
  this->WriteImageInformation();
}

void
StackImageIOBase::Reset()
{
  m_NumberOfChannels = 1;
  m_NumberOfFrames = 1;
  m_VoxelSize = {};
  m_IsInMicrometers = false;
  m_Warnings.clear();
}

void
StackImageIOBase::RequireChoice(unsigned int numberOfChannels, unsigned int numberOfFrames)
{
  m_NumberOfChannels = numberOfChannels;
  m_NumberOfFrames = numberOfFrames;
  const std::string channel = RefuseChoice(numberOfChannels, m_Channel, "channel");
  const std::string frame = RefuseChoice(numberOfFrames, m_Frame, "frame");
  const std::string both = channel + (channel.empty() || frame.empty() ? "" : "; ") + frame;
  if (!both.empty())
  {
    itkExceptionMacro(<< both);
  }
}

unsigned int
StackImageIOBase::ChosenChannel() const
{
  return m_NumberOfChannels > 1 ? m_Channel - 1 : 0;
}

unsigned int
StackImageIOBase::ChosenFrame() const
{
  return m_NumberOfFrames > 1 ? m_Frame - 1 : 0;
}

void
StackImageIOBase::SetStack(const std::array<SizeValueType, 3> &         size,
                           const std::array<std::optional<double>, 3> & voxelSize, bool isInMicrometers,
                           IOComponentEnum componentType)
{
  this->SetNumberOfDimensions(3);
  this->SetNumberOfComponents(1);
  this->SetComponentType(componentType);
  m_IsInMicrometers = isInMicrometers;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    const bool isLength = voxelSize[axis] && std::isfinite(*voxelSize[axis]) && *voxelSize[axis] > 0.0;
    m_VoxelSize[axis] = isLength ? voxelSize[axis] : std::nullopt;
    this->SetDimensions(axis, size[axis]);
    this->SetSpacing(axis, m_VoxelSize[axis].value_or(1.0));
    this->SetOrigin(axis, 0.0);
  }
}
} // namespace itk
