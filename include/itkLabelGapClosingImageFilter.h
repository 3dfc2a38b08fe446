/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelGapClosingImageFilter_h
#define itkLabelGapClosingImageFilter_h

#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <vector>

namespace itk
{
/** \class LabelGapClosingImageFilter
 * \brief Grows the cells of an eroded segmentation over the thin walls of background between them.
 *
 * A background voxel is in a gap if
 * - the morphological closing of all cells by a ball holds it, or it is in a void that this closing encloses and that
 * is nowhere farther than the gap width from a cell; and
 * - two cells at least are within the gap width of it.
 * It gets the label of the nearest cell, and the smallest label of several cells that are equally near. The exterior
 * thus stays as it is except for clefts between two cells that are narrower than the gap width. Distances are
 * Euclidean, between the centres of voxels, in physical units; gap widths hold to within one voxel.
 *
 * Input: three-dimensional, any integer pixel type and spacing. Holds a few images of four bytes a voxel as it works.
 *
 * Errors (ExceptionObject): a negative gap width.
 *
 * \sa LabelJunctionExtractionFilter
 * \sa SignedMaurerDistanceMapImageFilter
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT LabelGapClosingImageFilter : public ImageToImageFilter<TLabelImage, TLabelImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelGapClosingImageFilter);

  using Self = LabelGapClosingImageFilter;
  using Superclass = ImageToImageFilter<TLabelImage, TLabelImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using LabelPixelType = typename LabelImageType::PixelType;
  using IndexType = typename LabelImageType::IndexType;

  itkNewMacro(Self);
  itkTypeMacro(LabelGapClosingImageFilter, ImageToImageFilter);

  /** The label of the walls and of the exterior, which is not a cell's. The default is 0. */
  itkSetMacro(BackgroundLabel, LabelPixelType);
  itkGetConstMacro(BackgroundLabel, LabelPixelType);

  /** The width of the widest gap to close, in physical units. The default, 0, stands for an automatic width. That is
   * twice the median length of the runs of background between two different cells along the axes of the image; only
   * runs up to half the diameter of the mean cell are counted. */
  itkSetMacro(GapWidth, double);
  itkGetConstMacro(GapWidth, double);

  /** The gap width that was used, which is 0 if it was automatic and there is no gap. It is valid after the update. */
  itkGetConstMacro(UsedGapWidth, double);

  /** The number of voxels of background that became voxels of a cell. It is valid after the update. */
  itkGetConstMacro(NumberOfChangedVoxels, SizeValueType);

  /** The largest distance of a voxel that became one of a cell to the nearest voxel that this cell had before. It is
   * valid after the update. */
  itkGetConstMacro(LargestDistance, double);

  /** How well the gaps are closed: of the places on the lines of voxels where a cell is next to another one, or less
   * than the diameter of the mean cell away with background alone between them, the share of the latter; and the width
   * that nine tenths of these have at most, 0 where there are none. Valid after the update. */
  itkGetConstMacro(ShareOfGapsLeft, double);
  itkGetConstMacro(WidthOfGapsLeft, double);

protected:
  LabelGapClosingImageFilter() = default;
  ~LabelGapClosingImageFilter() override = default;

  void
  GenerateInputRequestedRegion() override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using MaskType = Image<unsigned char, 3>;
  using MaskPointer = typename MaskType::Pointer;
  using DistanceType = Image<float, 3>;

  struct Neighbour
  {
    typename LabelImageType::OffsetType offset;
    double                              distance;
  };

  /** The cell nearest to a voxel and its distance. The number of cells is 2 where there are more. */
  struct NearestCells
  {
    LabelPixelType nearest;
    double         distance;
    int            number;
  };

  /** Computes the automatic gap width. */
  double
  EstimateGapWidth() const;

  double
  ComputeMeanCellDiameter() const;

  /** Adds the lengths of the runs of background between two different cells, up to a limit, and the number of places
   * where two cells meet. */
  void
  CollectGapLengths(const LabelImageType * image, unsigned int axis, double limit, std::vector<double> & lengths,
                    SizeValueType & numberOfContacts) const;

  void
  MeasureGapsLeft();

  /** Computes the closing of all cells together with the narrow voids it encloses. */
  MaskPointer
  ComputeGapMask(double radius);

  /** Adds to the mask the voids in it that are nowhere farther than the gap width from a cell. */
  MaskPointer
  AddNarrowVoids(const MaskType * mask, const DistanceType * cellDistance) const;

  /** Lists the voxels around a voxel up to a distance, the nearest first. */
  std::vector<Neighbour>
  ComputeNeighbours(double radius) const;

  /** Looks around a voxel for the nearest cell, and on until there is a second one and no other is as near as the
   * first.
   */
  NearestCells
  FindNearestCells(const IndexType & index, const std::vector<Neighbour> & neighbours) const;

  /** Gives the voxels of the mask their labels. */
  void
  GrowCells(const MaskType * mask, double radius);

  double        m_GapWidth = 0.0;
  double        m_UsedGapWidth = 0.0;
  double        m_LargestDistance = 0.0;
  double        m_ShareOfGapsLeft = 0.0;
  double        m_WidthOfGapsLeft = 0.0;
  SizeValueType m_NumberOfChangedVoxels = 0;

  LabelPixelType m_BackgroundLabel = 0;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelGapClosingImageFilter.hxx"
#endif

#endif
