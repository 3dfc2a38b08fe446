/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkImageNoiseCalculator_h
#define itkImageNoiseCalculator_h

#include "itkImage.h"
#include "itkObject.h"
#include "itkObjectFactory.h"

#include <array>
#include <vector>

namespace itk
{
/** \class ImageNoiseCalculator
 * \brief Estimates the standard deviation of an image's noise, whatever the image shows.
 *
 * The second difference along all three axes at once, 27 voxels with the weights (1, -2, 1) of each axis, is 0 where
 * the image is linear along one of them, and small where it is smooth, as it is across walls and on the surface of
 * balls. What is left of it is noise, whose deviation it has sqrt(6) times for each axis (after J. Immerkaer 1996,
 * doi:10.1006/cviu.1996.0060). The lower quartile of its absolute value, over 0.3186, is that of normal noise, and does
 * not mind that the image is not smooth in half of the places, as where cells are small.
 *
 * This is done in blocks, as noise may depend on the place: that of the image is the median of all blocks'. Noise is
 * taken to be independent from voxel to voxel: of an image that was smoothed, or resampled, less is seen than there is.
 * Axes of fewer than three voxels do not count.
 *
 * Pixels: any scalar type. The buffer must hold the largest possible region. The result is the same for any number of
 * threads.
 *
 * \ingroup TissueTessellation
 */
template <typename TImage>
class ITK_TEMPLATE_EXPORT ImageNoiseCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(ImageNoiseCalculator);

  using Self = ImageNoiseCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using ImageType = TImage;
  using IndexType = typename ImageType::IndexType;

  static_assert(TImage::ImageDimension == 3, "A tissue has three dimensions.");

  itkNewMacro(Self);
  itkTypeMacro(ImageNoiseCalculator, Object);

  itkSetConstObjectMacro(Image, ImageType);

  /** About how many voxels a block is long. The default is 16. */
  itkSetClampMacro(BlockSize, SizeValueType, 1, NumericTraits<SizeValueType>::max());
  itkGetConstMacro(BlockSize, SizeValueType);

  void
  Compute();

  /** The standard deviation of the noise, in units of the image. It is valid after Compute(). */
  itkGetConstMacro(Deviation, double);

  /** The standard deviation of the noise in the block of a voxel, or in the nearest. It is valid after Compute(). */
  double
  GetLocalDeviation(const IndexType & index) const;

protected:
  ImageNoiseCalculator() = default;
  ~ImageNoiseCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using Triple = std::array<SizeValueType, 3>;

  /** The first voxel of a block along an axis, where the second difference exists. */
  IndexValueType
  GetBegin(unsigned int axis, SizeValueType block) const;

  /** Computes the deviation in the block of this number. */
  double
  ComputeBlock(SizeValueType number) const;

  bool
  Counts(unsigned int axis) const
  {
    return m_Image->GetLargestPossibleRegion().GetSize(axis) > 2;
  }

  typename ImageType::ConstPointer m_Image;
  SizeValueType                    m_BlockSize = 16;
  double                           m_Deviation = 0.0;
  Triple                           m_NumberOfBlocks{};
  std::vector<double>              m_LocalDeviations;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkImageNoiseCalculator.hxx"
#endif

#endif
