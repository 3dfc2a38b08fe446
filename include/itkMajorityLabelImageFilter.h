/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMajorityLabelImageFilter_h
#define itkMajorityLabelImageFilter_h

#include "itkImageToImageFilter.h"

#include <array>
#include <limits>
#include <vector>

namespace itk
{
/** \class MajorityLabelImageFilter
 * \brief Gives every voxel of a 3-D label image the label of the greatest weight in its 3x3x3 neighbourhood.
 *
 * Weights are binomial: 8 for the voxel itself, and half as much for each step along an axis. Among equals the voxel's
 * own label wins, or else the least. Beyond its border the image goes on as it is on the border.
 *
 * The filter smooths all boundaries between labels by less than a voxel and favours none of them; several passes smooth
 * more. Thin labels may be broken up, and small ones may vanish; no new label appears.
 *
 * \ingroup MultiThreaded TissueTessellation */
template <typename TImage>
class ITK_TEMPLATE_EXPORT MajorityLabelImageFilter : public ImageToImageFilter<TImage, TImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MajorityLabelImageFilter);

  using Self = MajorityLabelImageFilter;
  using Superclass = ImageToImageFilter<TImage, TImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using ImageType = TImage;
  using PixelType = typename ImageType::PixelType;
  using IndexType = typename ImageType::IndexType;
  using RegionType = typename ImageType::RegionType;

  static_assert(TImage::ImageDimension == 3, "The neighbourhood is of three dimensions.");
  static_assert(std::numeric_limits<PixelType>::is_integer, "Labels are integers.");

  itkNewMacro(Self);
  itkTypeMacro(MajorityLabelImageFilter, ImageToImageFilter);

protected:
  MajorityLabelImageFilter();
  ~MajorityLabelImageFilter() override = default;

  void
  GenerateInputRequestedRegion() override;

  void
  DynamicThreadedGenerateData(const RegionType & region) override;

private:
  /** The nine rows of the neighbourhood, the voxel's own as the fifth. Each begins at the start of the input's buffer.
   */
  using RowsType = std::array<const PixelType *, 9>;

  RowsType
  GetRows(const IndexType & index) const;

  static PixelType
  FindMajority(const RowsType & rows, SizeValueType before, SizeValueType x, SizeValueType after);
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMajorityLabelImageFilter.hxx"
#endif

#endif
