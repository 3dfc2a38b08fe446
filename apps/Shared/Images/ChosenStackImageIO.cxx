/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ChosenStackImageIO.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tissue
{
namespace
{
unsigned int
NumberOfFramesOf(const itk::ImageIOBase * source)
{
  return source->GetNumberOfDimensions() > 3 ? static_cast<unsigned int>(source->GetDimensions(3)) : 1;
}
} // namespace

bool
ChosenStackImageIO::IsFor(const itk::ImageIOBase * source)
{
  for (unsigned int axis = 4; axis < source->GetNumberOfDimensions(); ++axis)
  {
    if (source->GetDimensions(axis) > 1)
    {
      return false;
    }
  }
  const bool isVolume = source->GetNumberOfDimensions() > 2 && source->GetDimensions(2) > 1;
  return isVolume && (source->GetNumberOfComponents() > 1 || NumberOfFramesOf(source) > 1);
}

void
ChosenStackImageIO::ReadImageInformation()
{
  this->Reset();
  this->RequireChoice(m_Source->GetNumberOfComponents(), NumberOfFramesOf(m_Source));
  std::array<itk::SizeValueType, 3>    size{};
  std::array<std::optional<double>, 3> voxelSize;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    size[axis] = m_Source->GetDimensions(axis);
    voxelSize[axis] = m_Source->GetSpacing(axis);
  }
  this->SetStack(size, AreAllOnes(m_Source) ? decltype(voxelSize)() : voxelSize, false, m_Source->GetComponentType());
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    this->SetOrigin(axis, m_Source->GetOrigin(axis));
    std::vector<double> direction = m_Source->GetDirection(axis);
    direction.resize(3);
    this->SetDirection(axis, direction);
  }
  this->SetMetaDataDictionary(m_Source->GetMetaDataDictionary());
}

void
ChosenStackImageIO::Read(void * buffer)
{
  const unsigned int dimensions = m_Source->GetNumberOfDimensions();
  itk::ImageIORegion region(dimensions);
  for (unsigned int axis = 0; axis < dimensions; ++axis)
  {
    region.SetSize(axis, m_Source->GetDimensions(axis));
  }
  std::size_t first = 0;
  const auto  number = static_cast<std::size_t>(this->GetImageSizeInPixels());
  if (dimensions > 3 && m_Source->CanStreamRead())
  {
    region.SetIndex(3, this->ChosenFrame());
    region.SetSize(3, 1);
  }
  else
  {
    first = number * this->ChosenFrame();
  }
  m_Source->SetIORegion(region);
  const std::size_t component = m_Source->GetComponentSize();
  const std::size_t voxel = component * m_Source->GetNumberOfComponents();
  std::vector<char> voxels(region.GetNumberOfPixels() * voxel);
  m_Source->Read(voxels.data());
  const char * from = voxels.data() + first * voxel + component * this->ChosenChannel();
  for (std::size_t i = 0; i < number; ++i)
  {
    std::memcpy(static_cast<char *>(buffer) + i * component, from + i * voxel, component);
  }
}

bool
AreAllOnes(const itk::ImageIOBase * io)
{
  for (unsigned int axis = 0; axis < std::min(3u, io->GetNumberOfDimensions()); ++axis)
  {
    if (std::abs(io->GetSpacing(axis) - 1.0) >= 1e-6)
    {
      return false;
    }
  }
  return true;
}

const itk::ImageIOBase *
SourceOf(const itk::ImageIOBase * io)
{
  const auto * const stack = dynamic_cast<const ChosenStackImageIO *>(io);
  return stack != nullptr ? stack->GetSource() : io;
}
} // namespace tissue
