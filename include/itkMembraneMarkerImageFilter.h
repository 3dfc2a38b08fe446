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

namespace itk
{
/** \class MembraneMarkerImageFilter
 * \brief Finds a marker for each cell, and one for the exterior, in an image of bright cell membranes.
 *
 * Input: a three-dimensional scalar image of any pixel type. Output: 0 where nothing is marked, 1 in the exterior, and
 * a number from 2 on at each minimum of the smoothed image that is at least MinimumDepth deep, in raster order of their
 * first voxels.
 *
 * The exterior is the opening, by a ball of twice the cells' diameter, of what is dark in the smoothed image (by Otsu's
 * threshold): no cell is as large. The diameter is that of a ball as large as the median basin of the minima. The
 * exterior's marker stays ExteriorMargin away from its boundary; an image without such a place has no exterior.
 *
 * Errors (ExceptionObject): a pixel that is no finite number, an image of one value.
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

  /** Standard deviation of the smoothing, in physical units; 0: the edge of the cube of a voxel's volume. Default: 0.
   */
  itkSetClampMacro(Sigma, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(Sigma, double);

  /** Of the minima, over the range of the intensities of the smoothed image, 0 .. 1; default 0.015. */
  itkSetClampMacro(MinimumDepth, double, 0.0, 1.0);
  itkGetConstMacro(MinimumDepth, double);

  /** Over the cells' diameter; default 0.25. */
  itkSetClampMacro(ExteriorMargin, double, 0.0, 1e6);
  itkGetConstMacro(ExteriorMargin, double);

  /** Minima, the exterior not counted. Valid after the update. */
  itkGetConstMacro(NumberOfCells, SizeValueType);

  /** Whether an exterior was found. Valid after the update. */
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

  /** Numbers the minima from 1 on. */
  typename MarkerImageType::Pointer
  FindMinima(const LevelImageType * levels) const;

  double
  EstimateCellDiameter(const LevelImageType * levels, const MarkerImageType * minima) const;

  /** Distance to the mask, of its own voxels 0 or less. */
  typename DistanceImageType::Pointer
  ComputeDistance(const MaskImageType * mask) const;

  /** Distance to the centres of the balls of this radius without a bright voxel; large where there is no such ball. */
  typename DistanceImageType::Pointer
  ComputeDistanceToEmptiness(const LevelImageType * levels, double radius) const;

  /** Puts the markers in order; a minimum within `radius` of emptiness is none. */
  void
  WriteMarkers(const MarkerImageType * minima, const DistanceImageType * toEmptiness, double radius, double margin);

  double        m_Sigma = 0.0;
  double        m_MinimumDepth = 0.015;
  double        m_ExteriorMargin = 0.25;
  SizeValueType m_NumberOfCells = 0;
  bool          m_HasExterior = false;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMembraneMarkerImageFilter.hxx"
#endif

#endif
