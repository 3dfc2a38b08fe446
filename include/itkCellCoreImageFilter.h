/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellCoreImageFilter_h
#define itkCellCoreImageFilter_h

#include "TissueTessellationCore/Common/Types.h"
#include "itkImage.h"
#include "itkImageToImageFilter.h"

#include <vector>

namespace itk
{
/** \class CellCoreImageFilter
 * \brief The inner parts of the cells of an approximate label image, as markers of a watershed.
 *
 * Input: a three-dimensional label image of any integer pixel type. Output: 0 where nothing is marked, 1 in the depth
 * of the exterior, and a number from 2 on in the core of each cell; GetLabels() tells the cells' labels.
 *
 * A voxel's depth is its distance to the nearest voxel, of its own cell or another, that has another label beside it.
 * The border of the image is not such a boundary. The core of a cell is where the depth is at least CoreDepth times the
 * cell's largest, so every cell has one. The exterior is marked where its depth is more than the margin.
 *
 * Errors (ExceptionObject): no cell at all.
 *
 * \sa MembraneToTissueLabelImageFilter
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT CellCoreImageFilter : public ImageToImageFilter<TLabelImage, Image<std::uint32_t, 3>>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CellCoreImageFilter);

  using Self = CellCoreImageFilter;
  using LabelImageType = TLabelImage;
  using MarkerImageType = Image<std::uint32_t, 3>;
  using Superclass = ImageToImageFilter<LabelImageType, MarkerImageType>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelPixelType = typename LabelImageType::PixelType;

  itkNewMacro(Self);
  itkTypeMacro(CellCoreImageFilter, ImageToImageFilter);

  /** The label of the exterior. Label 0 is never a cell either. The default is 0. */
  itkSetMacro(ExteriorLabel, LabelPixelType);
  itkGetConstMacro(ExteriorLabel, LabelPixelType);

  /** The least depth of a core over the largest depth of its cell, 0 .. 1. The default is 0.5. */
  itkSetClampMacro(CoreDepth, double, 0.0, 1.0);
  itkGetConstMacro(CoreDepth, double);

  /** How far the exterior's marker stays from the cells, over the diameter of a ball that has the volume of the mean
   * cell. The default is 0.4. */
  itkSetClampMacro(ExteriorMargin, double, 0.0, 1e6);
  itkGetConstMacro(ExteriorMargin, double);

  /** The labels of the cells; that of marker m is at m - 2. They are valid after the update. */
  const std::vector<tissue::Label> &
  GetLabels() const
  {
    return m_Labels;
  }

protected:
  CellCoreImageFilter() = default;
  ~CellCoreImageFilter() override = default;

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

  /** Computes the depth of each voxel of the output, which must hold the numbers of the cells. */
  typename DistanceImageType::Pointer
  ComputeDepth();

  /** Puts 1 into the exterior and the numbers of the cells into these; returns the number of voxels of each marker. */
  std::vector<SizeValueType>
  NumberCells();

  LabelPixelType             m_ExteriorLabel = 0;
  double                     m_CoreDepth = 0.5;
  double                     m_ExteriorMargin = 0.4;
  std::vector<tissue::Label> m_Labels;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkCellCoreImageFilter.hxx"
#endif

#endif
