/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkTissueLabelVolume.h"

#include "TissueTessellationCore/Image/LabelVolume.h"

namespace itk
{
SizeValueType
TissueLabelVolume::GetNumberOfVoxels() const
{
  return m_LabelVolume ? m_LabelVolume->vertices.size() : 0;
}

const tissue::LabelVolume &
TissueLabelVolume::GetLabelVolume() const
{
  if (!m_LabelVolume)
  {
    itkExceptionMacro(
      "The label volume is empty: the filter that makes it has not been updated, or is not asked for it "
      "(GenerateLabelVolumeOn).");
  }
  return *m_LabelVolume;
}

void
TissueLabelVolume::SetLabelVolume(std::shared_ptr<const tissue::LabelVolume> volume)
{
  m_LabelVolume = std::move(volume);
  this->Modified();
}

void
TissueLabelVolume::Initialize()
{
  Superclass::Initialize();
  m_LabelVolume.reset();
}

void
TissueLabelVolume::Graft(const DataObject * data)
{
  const auto * const other = dynamic_cast<const Self *>(data);
  if (!other)
  {
    itkExceptionMacro("Only another TissueLabelVolume can be grafted onto this one.");
  }
  m_LabelVolume = other->m_LabelVolume;
}

void
TissueLabelVolume::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Voxels: " << this->GetNumberOfVoxels() << std::endl;
}
} // namespace itk
