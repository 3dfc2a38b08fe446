/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellSignalCalculator_h
#define itkCellSignalCalculator_h

#include "itkCellWallMesh.h"
#include "itkImage.h"
#include "itkMultiThreaderBase.h"
#include "itkTissueLabelVolume.h"

#ifndef ITK_WRAPPING_PARSER // which reads C++11
#  include "TissueTessellationCore/Statistics/TissueStatistics.h"
#else
namespace tissue
{
struct CellSignal;
}
#endif

namespace itk
{
/** \class CellSignalCalculator
 * \brief Projects an image of intensities, as of a reporter, on the cells of a tissue and on their walls.
 *
 * Inputs: the image, of any scalar type, whose buffer must hold the largest possible region, in the physical space of
 * the tissue, on any grid; and, of LabelJunctionExtractionFilter and a filter after it, the label volume, which says
 * which voxels are a cell's, and the mesh of the walls. This is the projection of functional information on the cells
 * of section 5 of the paper.
 *
 * Where the image's voxels are not larger than those of the labels, each of its voxels counts for the cell that its
 * centre is in; where they are larger, the image is interpolated linearly at those of the labels (ResampleImageFilter).
 * What is outside of the image, and voxels that are not finite, are not known and left out; what is not known at all is
 * not a number. Intensities are taken in single precision, sums are of double precision.
 *
 * - Of a cell: the mean over its voxels; the integral, which is their sum times the volume of a voxel, in units of
 *   intensity times cubed lengths; and the mean over those whose centres are within WallDistance of the cell's walls.
 * - Of a wall: the mean over its area of the image, interpolated linearly.
 *
 * The result does not depend on the number of work units; LabelStatisticsImageFilter, which merges its threads' sums as
 * they come, would differ by rounding.
 *
 * \sa LabelImageToCellWallMeshFilter LabelStatisticsImageFilter
 * \ingroup TissueTessellation
 */
template <typename TInputImage>
class ITK_TEMPLATE_EXPORT CellSignalCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CellSignalCalculator);

  using Self = CellSignalCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using ImageType = TInputImage;
  using ValuesContainer = CellWallMesh::CoordinatesContainer;

  itkNewMacro(Self);
  itkTypeMacro(CellSignalCalculator, Object);

  itkSetConstObjectMacro(Image, ImageType);
  itkSetConstObjectMacro(LabelVolume, TissueLabelVolume);
  itkSetConstObjectMacro(Mesh, CellWallMesh);

  /** How near to its walls a cell's voxels are that count as such, in physical units. 0, the default: the diagonal of a
   * voxel of the image. */
  itkSetClampMacro(WallDistance, double, 0.0, NumericTraits<double>::max());
  itkGetConstMacro(WallDistance, double);

  /** Default: that of MultiThreaderBase. */
  void
  SetNumberOfWorkUnits(ThreadIdType number);
  ThreadIdType
  GetNumberOfWorkUnits() const;

  /** \throws ExceptionObject: an input that is not set or empty, a label volume that is not of the mesh, an image that
   * has no voxel in a cell. */
  void
  Compute();

  /** The distance that was used. */
  itkGetConstMacro(UsedWallDistance, double);

  /** Of each cell, in ascending order of the labels, and of each wall, in the order of the mesh. */
  ValuesContainer::Pointer
  GetMeans() const;
  ValuesContainer::Pointer
  GetIntegrals() const;
  ValuesContainer::Pointer
  GetMeansNearWalls() const;
  ValuesContainer::Pointer
  GetMeansOfWalls() const;

#ifndef ITK_WRAPPING_PARSER
  /** The same, for C++: by vertex, that of the exterior being empty, and by wall. Empty before Compute(). */
  const std::vector<tissue::CellSignal> &
  GetCellSignals() const
  {
    return m_CellSignals;
  }

  const std::vector<double> &
  GetWallMeans() const
  {
    return m_WallMeans;
  }
#endif

protected:
  CellSignalCalculator();
  ~CellSignalCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  using FieldType = Image<float, 3>;

  void
  CheckInputs() const;

  /** The image, or its values at the voxels of the labels. */
  typename FieldType::Pointer
  MakeField() const;

  std::vector<double>
  MeasureWalls(const tissue::WallMesh & mesh) const;

  ValuesContainer::Pointer
  Collect(double tissue::CellSignal::*member) const;

  typename ImageType::ConstPointer m_Image;
  TissueLabelVolume::ConstPointer  m_LabelVolume;
  CellWallMesh::ConstPointer       m_Mesh;
  MultiThreaderBase::Pointer       m_MultiThreader;
  double                           m_WallDistance = 0.0;
  double                           m_UsedWallDistance = 0.0;
  std::vector<tissue::CellSignal>  m_CellSignals;
  std::vector<double>              m_WallMeans;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkCellSignalCalculator.hxx"
#endif

#endif
