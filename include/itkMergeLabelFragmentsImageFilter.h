/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMergeLabelFragmentsImageFilter_h
#define itkMergeLabelFragmentsImageFilter_h

#include "itkInPlaceImageFilter.h"

#include <limits>

namespace tissue
{
struct LabelRuns;
} // namespace tissue

namespace itk
{
/** \class MergeLabelFragmentsImageFilter
 * \brief Makes every label of a 3-D label image one 6-connected piece, with no voxel left over.
 *
 * Each label keeps its largest piece; of equally large ones it keeps the first in raster order. Each of its other
 * pieces goes to the label, of a cell or the exterior, with which it shares the most voxel faces; of equals to the
 * least. The exterior is different: it keeps all pieces that touch the image's border and no others, so its voids are
 * filled.
 *
 * No label vanishes, except that of an exterior off the border. The filter works on the whole image, by runs of voxels:
 * its time and memory are those of reading the image and of its number of runs.
 *
 * \ingroup TissueTessellation */
template <typename TImage>
class ITK_TEMPLATE_EXPORT MergeLabelFragmentsImageFilter : public InPlaceImageFilter<TImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MergeLabelFragmentsImageFilter);

  using Self = MergeLabelFragmentsImageFilter;
  using Superclass = InPlaceImageFilter<TImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using ImageType = TImage;
  using PixelType = typename ImageType::PixelType;
  using RegionType = typename ImageType::RegionType;

  static_assert(TImage::ImageDimension == 3, "The runs are those of three dimensions.");
  static_assert(std::numeric_limits<PixelType>::is_integer, "Labels are integers.");

  itkNewMacro(Self);
  itkTypeMacro(MergeLabelFragmentsImageFilter, InPlaceImageFilter);

  /** The label of the exterior. The default is 0. */
  itkSetMacro(ExteriorLabel, PixelType);
  itkGetConstMacro(ExteriorLabel, PixelType);

  /** The number of voxels whose label changed in the last update. */
  itkGetConstMacro(NumberOfChangedVoxels, SizeValueType);

protected:
  MergeLabelFragmentsImageFilter() = default;
  ~MergeLabelFragmentsImageFilter() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  GenerateInputRequestedRegion() override;
  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

private:
  /** Finds the runs of equal labels in the rows of the input. */
  tissue::LabelRuns
  FindRuns();

  PixelType     m_ExteriorLabel{ 0 };
  SizeValueType m_NumberOfChangedVoxels{ 0 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMergeLabelFragmentsImageFilter.hxx"
#endif

#endif
