/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMembraneMarkerImageFilter_h
#define itkMembraneMarkerImageFilter_h

#include "itkImage.h"
#include "itkImageToImageFilter.h"
#include "itkSmoothedLevels.h"

#include <vector>

namespace itk
{
/** \class MembraneMarkerImageFilter
 * \brief Finds a marker for each cell, and one for the exterior, in an image of cell membranes.
 *
 * Input: a three-dimensional scalar image of any pixel type. Output: 0 where nothing is marked, 1 in the exterior, and
 * a number from 2 on at each minimum of the smoothed image that is at least MinimumDepth deep, and NoiseDepth times the
 * deviation of what the smoothing leaves of the image's noise (ImageNoiseCalculator), in raster order of their first
 * voxels. Dark membranes are those of the inverse image.
 *
 * The exterior is the opening of the dark part of the smoothed image (by Otsu's threshold) by a ball of twice the
 * cells' diameter, which is larger than any cell. The cells' diameter is that of a ball as large as the median basin of
 * the minima. The exterior's marker stays ExteriorMargin away from its boundary; an image without such a place has no
 * exterior.
 *
 * Errors (ExceptionObject): a pixel that is not a finite number, an image of one value.
 *
 * \sa MembraneToTissueLabelImageFilter
 * \ingroup TissueTessellation
 */
template <typename TMembraneImage>
class ITK_TEMPLATE_EXPORT MembraneMarkerImageFilter : public ImageToImageFilter<TMembraneImage, Image<std::uint32_t, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MembraneMarkerImageFilter);

  using Self = MembraneMarkerImageFilter;
  using MembraneImageType = TMembraneImage;
  using MarkerImageType = Image<std::uint32_t, 3>;
  using Superclass = ImageToImageFilter<MembraneImageType, MarkerImageType>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(MembraneMarkerImageFilter, ImageToImageFilter);

  /** Tells whether the membranes are darker than the cells, as in bright field, instead of brighter; the exterior is
   * bright then. The default is off. */
  itkSetMacro(DarkMembranes, bool);
  itkGetConstMacro(DarkMembranes, bool);
  itkBooleanMacro(DarkMembranes);

  /** The standard deviation of the smoothing, in physical units. 0, the default, stands for the edge of a cube that has
   * the volume of a voxel. */
  itkSetClampMacro(Sigma, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(Sigma, double);

  /** The least depth of a minimum, over the range of the intensities of the smoothed image, 0 .. 1. The default is
   * 0.015.
   */
  itkSetClampMacro(MinimumDepth, double, 0.0, 1.0);
  itkGetConstMacro(MinimumDepth, double);

  /** The least depth of a minimum, over the deviation of the noise of the smoothed image. The default is 3. */
  itkSetClampMacro(NoiseDepth, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(NoiseDepth, double);

  /** How far the exterior's marker stays from the exterior's boundary, over the cells' diameter. The default is 0.25.
   */
  itkSetClampMacro(ExteriorMargin, double, 0.0, 1e6);
  itkGetConstMacro(ExteriorMargin, double);

  /** The standard deviation of the image's noise, as estimated, in units of the image. It is valid after the update. */
  itkGetConstMacro(Noise, double);

  /** The least depth that was used, over the range of the intensities of the smoothed image: the larger one of
   * MinimumDepth and that of the noise. It is valid after the update. */
  itkGetConstMacro(UsedDepth, double);

  /** The number of minima that mark cells. It is valid after the update. */
  itkGetConstMacro(NumberOfCells, SizeValueType);

  /** Tells whether an exterior was found. It is valid after the update. */
  itkGetConstMacro(HasExterior, bool);

protected:
  MembraneMarkerImageFilter() = default;
  ~MembraneMarkerImageFilter() override = default;

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using DistanceImageType = Image<float, 3>;
  using MaskImageType = Image<unsigned char, 3>;

  /** Estimates the noise, and what is the least depth of a minimum in levels smoothed by `sigma`. */
  void
  ChooseDepth(const SmoothedLevels & levels, double sigma);

  /** Numbers the minima from 1 on. */
  typename MarkerImageType::Pointer
  FindMinima(const LevelImageType * levels) const;

  /** Floods the image from its minima, and gives the diameter of a ball as large as the median basin. */
  double
  EstimateCellDiameter(const LevelImageType * levels, const MarkerImageType * minima) const;

  /** Computes the distance to the mask, which is 0 or less in the mask. */
  typename DistanceImageType::Pointer
  ComputeDistance(const MaskImageType * mask) const;

  /** Computes the distance to the centres of the balls of this radius that hold no bright voxel. It is large everywhere
   * if there is no such ball. */
  typename DistanceImageType::Pointer
  ComputeDistanceToEmptiness(const LevelImageType * levels, double radius) const;

  /** Tells for each minimum whether it marks a cell. One within `radius` of emptiness does not, nor one that is larger
   * than two cells and reaches so far into the exterior that it is marked: noise there is filled up to a minimum.
   */
  std::vector<char>
  FindCells(const MarkerImageType * minima, const DistanceImageType * toEmptiness, double radius, double margin) const;

  /** Numbers the markers of the cells in raster order, and marks the exterior. */
  void
  WriteMarkers(const MarkerImageType * minima, const DistanceImageType * toEmptiness, double radius, double margin);

  bool          m_DarkMembranes = false;
  double        m_Sigma = 0.0;
  double        m_MinimumDepth = 0.015;
  double        m_NoiseDepth = 3.0;
  double        m_ExteriorMargin = 0.25;
  double        m_Noise = 0.0;
  double        m_UsedDepth = 0.0;
  SizeValueType m_NumberOfCells = 0;
  bool          m_HasExterior = false;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMembraneMarkerImageFilter.hxx"
#endif

#endif
