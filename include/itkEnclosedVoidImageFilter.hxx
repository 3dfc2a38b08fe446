/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkEnclosedVoidImageFilter_hxx
#define itkEnclosedVoidImageFilter_hxx

#include "itkEnclosedVoidImageFilter.h"

#include "TissueTessellationCore/Image/LabelIndexer.h"
#include "itkConnectedComponentImageFilter.h"
#include "itkImageRegionConstIterator.h"
#include "itkImageRegionIterator.h"

#include <algorithm>

namespace itk
{
template <typename TLabelImage>
void
EnclosedVoidImageFilter<TLabelImage>::GenerateInputRequestedRegion()
{
  Superclass::GenerateInputRequestedRegion();
  const_cast<LabelImageType *>(this->GetInput())->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
void
EnclosedVoidImageFilter<TLabelImage>::EnlargeOutputRequestedRegion(DataObject * output)
{
  output->SetRequestedRegionToLargestPossibleRegion();
}

template <typename TLabelImage>
auto
EnclosedVoidImageFilter<TLabelImage>::ConnectExterior() const -> typename VoidImageType::Pointer
{
  using MaskType = Image<unsigned char, 3>;
  const LabelImageType * labels = this->GetInput();
  const auto             mask = MaskType::New();
  mask->CopyInformation(labels);
  mask->SetRegions(labels->GetLargestPossibleRegion());
  mask->Allocate();
  ImageRegionConstIterator<LabelImageType> label(labels, labels->GetLargestPossibleRegion());
  for (ImageRegionIterator<MaskType> it(mask, mask->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it, ++label)
  {
    it.Set(m_Exterior->Contains(static_cast<tissue::Label>(label.Get())) ? 1 : 0);
  }
  const auto connect = ConnectedComponentImageFilter<MaskType, VoidImageType>::New();
  connect->SetInput(mask);
  connect->SetNumberOfWorkUnits(const_cast<Self *>(this)->GetNumberOfWorkUnits());
  connect->Update();
  return connect->GetOutput();
}

template <typename TLabelImage>
auto
EnclosedVoidImageFilter<TLabelImage>::FindNeighbors(const VoidImageType * pieces) const
  -> std::vector<std::set<typename LabelImageType::PixelType>>
{
  // One pass over the voxels of all pieces. A piece with a voxel on the border is open; for the others the labels of
  // the voxels beside theirs are collected. A voxel beside a piece that is in no piece is a cell's.
  using PixelType = typename LabelImageType::PixelType;
  const auto            region = pieces->GetLargestPossibleRegion();
  const auto            size = region.GetSize();
  const auto * const    piece = pieces->GetBufferPointer();
  const auto * const    label = this->GetInput()->GetBufferPointer();
  const OffsetValueType stride[3] = { 1,
                                      static_cast<OffsetValueType>(size[0]),
                                      static_cast<OffsetValueType>(size[0] * size[1]) };
  const auto            numberOfVoxels = static_cast<OffsetValueType>(region.GetNumberOfPixels());

  std::vector<char>                isOpen;
  std::vector<std::set<PixelType>> neighbors;
  for (OffsetValueType i = 0; i < numberOfVoxels; ++i)
  {
    const std::uint32_t p = piece[i];
    if (p == 0)
    {
      continue;
    }
    if (p >= neighbors.size())
    {
      neighbors.resize(p + 1);
      isOpen.resize(p + 1, 0);
    }
    if (isOpen[p])
    {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto position = static_cast<SizeValueType>(i / stride[axis]) % size[axis];
      isOpen[p] = isOpen[p] || position == 0 || position + 1 == size[axis];
    }
    for (int axis = 0; axis < 3 && !isOpen[p]; ++axis)
    {
      for (const OffsetValueType step : { -stride[axis], stride[axis] })
      {
        if (piece[i + step] == 0)
        {
          neighbors[p].insert(label[i + step]);
        }
      }
    }
  }
  for (std::size_t p = 0; p < neighbors.size(); ++p)
  {
    if (isOpen[p])
    {
      neighbors[p].clear();
    }
  }
  return neighbors;
}

template <typename TLabelImage>
void
EnclosedVoidImageFilter<TLabelImage>::GenerateData()
{
  if (m_Exterior == nullptr)
  {
    itkExceptionMacro(<< "The exterior labels are not set.");
  }
  const typename VoidImageType::Pointer pieces = this->ConnectExterior();
  const auto                            neighbors = this->FindNeighbors(pieces);
  // Numbers go by the order of the voids' first voxels, whatever the order of the pieces.
  std::vector<std::uint32_t> numbers(neighbors.size(), 0);
  m_NumberOfVoids = 0;
  for (ImageRegionIterator<VoidImageType> it(pieces, pieces->GetLargestPossibleRegion()); !it.IsAtEnd(); ++it)
  {
    std::uint32_t p = it.Get();
    if (p != 0)
    {
      if (numbers[p] == 0 && neighbors[p].size() >= m_MinimumNumberOfNeighbors)
      {
        numbers[p] = ++m_NumberOfVoids;
      }
      it.Set(numbers[p]);
    }
  }
  this->GraftOutput(pieces);
}

template <typename TLabelImage>
void
EnclosedVoidImageFilter<TLabelImage>::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "MinimumNumberOfNeighbors: " << m_MinimumNumberOfNeighbors << std::endl;
  os << indent << "NumberOfVoids: " << m_NumberOfVoids << std::endl;
}
} // namespace itk

#endif
