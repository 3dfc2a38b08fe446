/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkMembraneToTissueLabelImageFilter_h
#define itkMembraneToTissueLabelImageFilter_h

#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <vector>

namespace itk
{
/** \class MembraneToTissueLabelImageFilter
 * \brief Makes the label image of the cells from an image of cell membranes, by a watershed from markers.
 *
 * The mini-pipeline:
 *
 *     approximate cells -> resampled -> CellCoreImageFilter --+
 *                     (or) MembraneMarkerImageFilter ---------+-> markers -+
 *     membrane image -> smoothed ------------------------------------------+-> MorphologicalWatershedFromMarkers
 *
 * Inputs: a three-dimensional scalar image of any pixel type and, optionally, a label image that tells about where each
 * cell is (SetCellImage(), such as PointSetToTissueLabelImageFilter makes of points), on any grid: it is brought to
 * that of the membranes by its nearest voxels, and beyond it is exterior. With it the output has its labels and its
 * exterior label, and every cell has at least the core it has there. Without it the markers are the minima of the
 * membrane image, and the labels are 1, 2, ... in raster order of these. Membranes are bright, or with
 * DarkMembranesOn() dark.
 *
 * Output: on the grid of the membrane image; every voxel is a cell's or the exterior's.
 *
 * Errors (ExceptionObject): a pixel that is not a finite number, with its place; an image of one value; no cell; cells
 * of the cell image that lie outside of the membrane image; more cells than the output's pixel type can number.
 *
 * \sa CellCoreImageFilter MembraneMarkerImageFilter MorphologicalWatershedFromMarkersImageFilter
 * \ingroup TissueTessellation
 */
template <typename TMembraneImage, typename TLabelImage>
class ITK_TEMPLATE_EXPORT MembraneToTissueLabelImageFilter : public ImageToImageFilter<TMembraneImage, TLabelImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(MembraneToTissueLabelImageFilter);

  using Self = MembraneToTissueLabelImageFilter;
  using Superclass = ImageToImageFilter<TMembraneImage, TLabelImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using MembraneImageType = TMembraneImage;
  using LabelImageType = TLabelImage;
  using LabelPixelType = typename LabelImageType::PixelType;

  itkNewMacro(Self);
  itkTypeMacro(MembraneToTissueLabelImageFilter, ImageToImageFilter);

  /** Sets the label image that tells about where the cells are. It is optional. */
  void
  SetCellImage(const LabelImageType * cells);

  const LabelImageType *
  GetCellImage() const;

  /** The label of the exterior in the cell image and in the output. The default is 0. */
  itkSetMacro(ExteriorLabel, LabelPixelType);
  itkGetConstMacro(ExteriorLabel, LabelPixelType);

  /** Tells whether the membranes are darker than the cells, as in bright field, instead of brighter; the exterior is
   * bright then. The default is off. */
  itkSetMacro(DarkMembranes, bool);
  itkGetConstMacro(DarkMembranes, bool);
  itkBooleanMacro(DarkMembranes);

  /** The standard deviation of the smoothing of the image that is flooded, in physical units. 0, the default, stands
   * for no smoothing. */
  itkSetClampMacro(Sigma, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(Sigma, double);

  /** The least depth of a core over the largest depth of its cell (CellCoreImageFilter). The default is 0.5. */
  itkSetClampMacro(CoreDepth, double, 0.0, 1.0);
  itkGetConstMacro(CoreDepth, double);

  /** The standard deviation of the smoothing before minima are looked for, in physical units, where there is no cell
   * image (MembraneMarkerImageFilter::SetSigma()). 0, the default, stands for the edge of a voxel. */
  itkSetClampMacro(MarkerSigma, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(MarkerSigma, double);

  /** The least depth of a minimum over the range of the intensities (MembraneMarkerImageFilter). The default is 0.015.
   */
  itkSetClampMacro(MinimumDepth, double, 0.0, 1.0);
  itkGetConstMacro(MinimumDepth, double);

  /** The least depth of a minimum over the deviation of the smoothed image's noise (MembraneMarkerImageFilter). The
   * default is 3. */
  itkSetClampMacro(NoiseDepth, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(NoiseDepth, double);

  /** The standard deviation of the image's noise and the least depth of a minimum that was used
   * (MembraneMarkerImageFilter); 0 with a cell image. They are valid after the update. */
  itkGetConstMacro(Noise, double);
  itkGetConstMacro(UsedDepth, double);

  /** The number of cells in the output. It is valid after the update. */
  itkGetConstMacro(NumberOfCells, SizeValueType);

protected:
  MembraneToTissueLabelImageFilter();
  ~MembraneToTissueLabelImageFilter() override = default;

  void
  VerifyInputInformation() const override
  {} // The cell image may have another grid.

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using MarkerImageType = Image<std::uint32_t, 3>;

  /** Brings the cell image to the grid of the membrane image. Throws where a cell is lost by it. */
  typename LabelImageType::Pointer
  ResampleCells();

  /** Makes the markers, and sets their labels. Both no marker and the exterior's marker have the exterior's label. */
  typename MarkerImageType::Pointer
  MakeMarkers(std::vector<LabelPixelType> & labels);

  typename MarkerImageType::Pointer
  MarkCores(std::vector<LabelPixelType> & labels);

  typename MarkerImageType::Pointer
  MarkMinima(std::vector<LabelPixelType> & labels);

  LabelPixelType m_ExteriorLabel = 0;
  bool           m_DarkMembranes = false;
  double         m_Sigma = 0.0;
  double         m_CoreDepth = 0.5;
  double         m_MarkerSigma = 0.0;
  double         m_MinimumDepth = 0.015;
  double         m_NoiseDepth = 3.0;
  double         m_Noise = 0.0;
  double         m_UsedDepth = 0.0;
  SizeValueType  m_NumberOfCells = 0;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkMembraneToTissueLabelImageFilter.hxx"
#endif

#endif
