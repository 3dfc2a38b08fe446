/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkSyntheticTissueImageSource_h
#define itkSyntheticTissueImageSource_h

#include "itkGenerateImageSource.h"
#include "itkImageToImageFilter.h"
#include "itkSyntheticTissueEnums.h"

#include <cstdint>
#include <limits>

namespace tissue
{
class AnisotropicTessellation;
} // namespace tissue

namespace itk
{
/** \class SyntheticTissueImageSource
 * \brief Makes label images like those of segmented plant tissues.
 *
 * The output is a 3-D image of an integer pixel type, with size, spacing, origin and direction of the superclass. Every
 * cell is one 6-connected piece. There are exactly NumberOfCells of them; their labels ascend by one from
 * FirstCellLabel, skipping ExteriorLabel, which all other voxels have. Cells are even in physical units, whatever the
 * spacing; the shape fills the image up to the margin.
 *
 * The same parameters give the same image on every machine and for any number of threads; origin and direction change
 * no voxel.
 *
 * Exceptions: a margin that leaves no tissue, a spacing that is not positive, an anisotropy below 1, labels that the
 * pixel type cannot hold, fewer than 27 voxels of tissue a cell, a cell lost to the smoothing of walls.
 *
 * \ingroup DataSources MultiThreaded TissueTessellation */
template <typename TOutputImage>
class ITK_TEMPLATE_EXPORT SyntheticTissueImageSource : public GenerateImageSource<TOutputImage>
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(SyntheticTissueImageSource);

  using Self = SyntheticTissueImageSource;
  using Superclass = GenerateImageSource<TOutputImage>;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using OutputImageType = TOutputImage;
  using PixelType = typename OutputImageType::PixelType;
  using RegionType = typename OutputImageType::RegionType;
  using SizeType = typename OutputImageType::SizeType;
  using IndexType = typename OutputImageType::IndexType;
  using ShapeEnum = SyntheticTissueEnums::Shape;
  using CellModelEnum = SyntheticTissueEnums::CellModel;

  static_assert(TOutputImage::ImageDimension == 3, "A tissue has three dimensions.");
  static_assert(std::numeric_limits<PixelType>::is_integer, "Labels are integers.");

  itkNewMacro(Self);
  itkTypeMacro(SyntheticTissueImageSource, GenerateImageSource);

  /** The number of cells, at least 1. The default is 100. */
  itkSetMacro(NumberOfCells, uint32_t);
  itkGetConstMacro(NumberOfCells, uint32_t);

  /** The seed of the random numbers: each gives another tissue. The default is 0. */
  itkSetMacro(Seed, uint64_t);
  itkGetConstMacro(Seed, uint64_t);

  /** The outline of the tissue. The default is Dome. */
  itkSetEnumMacro(Shape, ShapeEnum);
  itkGetEnumMacro(Shape, ShapeEnum);

  /** How the tissue is made into cells. The default is Anisotropic. */
  itkSetEnumMacro(CellModel, CellModelEnum);
  itkGetEnumMacro(CellModel, CellModelEnum);

  /** The greatest ratio of the longest to the shortest axis of the metric of an anisotropic cell. It is at least 1,
   * where all are Voronoi cells. The default is 3.5. */
  itkSetMacro(Anisotropy, double);
  itkGetConstMacro(Anisotropy, double);

  /** The number of exterior voxels left between the shape and each side of the image. The default is 4. */
  itkSetMacro(Margin, SizeValueType);
  itkGetConstMacro(Margin, SizeValueType);

  /** How often each voxel takes the label of the majority of its 3x3x3 neighbourhood, in which near voxels count more.
   * This rounds edges and corners off; 0 leaves the walls as the model has them. The default is 2. */
  itkSetMacro(Smoothing, unsigned int);
  itkGetConstMacro(Smoothing, unsigned int);

  /** The label of the exterior. The default is 0. */
  itkSetMacro(ExteriorLabel, PixelType);
  itkGetConstMacro(ExteriorLabel, PixelType);

  /** The least label of a cell. The default is 1. */
  itkSetMacro(FirstCellLabel, PixelType);
  itkGetConstMacro(FirstCellLabel, PixelType);

protected:
  SyntheticTissueImageSource() = default;
  ~SyntheticTissueImageSource() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

  void
  VerifyPreconditions() ITKv5_CONST override;

  void
  EnlargeOutputRequestedRegion(DataObject * output) override;

  void
  GenerateData() override;

private:
  void
  VerifyMargin() const;
  /** Gives how much the label of a cell, counted from 0, exceeds the first one's. The exterior's label is skipped. */
  uint64_t
  GetLabelOffset(uint64_t cell) const;
  PixelType
  GetLabelOfCell(uint64_t cell) const;
  bool
  IsInside(const IndexType & index) const;

  /** This function and the following ones are the phases of GenerateData, in their order. The first fills the output
   * with the exterior label and, in the shape, the first cell's, and returns the number of voxels in the shape. */
  SizeValueType
  MarkTissue();
  tissue::AnisotropicTessellation
  GrowCells(double cellDiameter);
  void
  AssignCells(const tissue::AnisotropicTessellation & cells, double cellDiameter);
  void
  SmoothWalls();
  void
  MergeFragments();
  void
  VerifyCells() const;

  /** Replaces the output's voxels by what the filter makes of them. */
  void
  RunOnOutput(ImageToImageFilter<TOutputImage, TOutputImage> * filter, float progressStart, float progressEnd);

  uint32_t      m_NumberOfCells{ 100 };
  uint64_t      m_Seed{ 0 };
  ShapeEnum     m_Shape{ ShapeEnum::Dome };
  CellModelEnum m_CellModel{ CellModelEnum::Anisotropic };
  double        m_Anisotropy{ 3.5 };
  SizeValueType m_Margin{ 4 };
  unsigned int  m_Smoothing{ 2 };
  PixelType     m_ExteriorLabel{ 0 };
  PixelType     m_FirstCellLabel{ 1 };
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkSyntheticTissueImageSource.hxx"
#endif

#endif
