/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkEnclosedVoidImageFilter_h
#define itkEnclosedVoidImageFilter_h

#include "itkImageToImageFilter.h"

#include <set>
#include <vector>

namespace tissue
{
struct ExteriorLabels;
}

namespace itk
{
/** \class EnclosedVoidImageFilter
 * \brief Numbers the voids of the exterior that a tissue encloses.
 *
 * Input: a label image. Output: 1, 2, ... in the enclosed voids, 0 elsewhere. An enclosed void is a face-connected
 * piece of the exterior's voxels without a voxel on the image's border, with at least MinimumNumberOfNeighbors cells at
 * its faces: with fewer it cannot be a vertex of an adjacency complex. Numbers ascend in raster order of the first
 * voxels.
 *
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT EnclosedVoidImageFilter : public ImageToImageFilter<TLabelImage, Image<std::uint32_t, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(EnclosedVoidImageFilter);

  using Self = EnclosedVoidImageFilter;
  using LabelImageType = TLabelImage;
  using VoidImageType = Image<std::uint32_t, 3>;
  using Superclass = ImageToImageFilter<LabelImageType, VoidImageType>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(EnclosedVoidImageFilter, ImageToImageFilter);

  /** Sets the labels that are the exterior. They are required, and must outlive the update. */
  void
  SetExteriorLabels(const tissue::ExteriorLabels * exterior)
  {
    m_Exterior = exterior;
    this->Modified();
  }

  /** The least number of cells at the faces of an enclosed void. The default is 4, as many as a vertex of a closed
   * complex must have. */
  itkSetMacro(MinimumNumberOfNeighbors, SizeValueType);
  itkGetConstMacro(MinimumNumberOfNeighbors, SizeValueType);

  /** The number of enclosed voids that were found. It is valid after the update. */
  itkGetConstMacro(NumberOfVoids, std::uint32_t);

protected:
  EnclosedVoidImageFilter() = default;
  ~EnclosedVoidImageFilter() override = default;

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** Numbers the face-connected pieces of the exterior. */
  typename VoidImageType::Pointer
  ConnectExterior() const;

  /** Finds for each piece of the exterior the labels of the cells at its faces, and none for a piece on the border. */
  std::vector<std::set<typename LabelImageType::PixelType>>
  FindNeighbors(const VoidImageType * pieces) const;

  const tissue::ExteriorLabels * m_Exterior = nullptr;
  SizeValueType                  m_MinimumNumberOfNeighbors = 4;
  std::uint32_t                  m_NumberOfVoids = 0;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkEnclosedVoidImageFilter.hxx"
#endif

#endif
