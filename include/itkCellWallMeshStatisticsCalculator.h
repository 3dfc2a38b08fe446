/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellWallMeshStatisticsCalculator_h
#define itkCellWallMeshStatisticsCalculator_h

#include "TissueTessellationExport.h"
#include "itkCellWallMesh.h"
#include "itkObject.h"
#include "itkObjectFactory.h"

#include <memory>
#include <string>
#include <vector>

namespace tissue
{
struct CellRemark;
struct CellSurfaceCheck;
struct StatisticColumn;
struct TissueStatistics;
} // namespace tissue

namespace itk
{
/** \class CellWallMeshStatisticsCalculator
 * \brief Measures the cells and the walls of a mesh of this module, and tells what is to be remarked of its cells.
 *
 * Tables of cells and of walls, column by column, as flat arrays: tissue::MeasureTissue(), tissue::CheckCellSurfaces()
 * and what the image has of the cells. Rows of cells are in ascending order of their labels, without the exterior; rows
 * of walls by their numbers, which CellWallMesh::GetTriangleWalls() gives of each triangle. Lengths, areas and volumes
 * are in the image's units; what cannot be measured is not a number. A column of vectors has 3 components a row.
 *
 * The cells' columns: `Label`, `CenterX`, `CenterY`, `CenterZ` (barycentre in the image), `Volume` (within its walls),
 * `ImageVolume`, `SurfaceArea`, `NumberOfNeighbors`, `NumberOfTriangles`, `EulerCharacteristic`, `MinimumDihedralAngle`
 * (degrees), `IsClosed`, `TouchesExterior`, `TouchesBorder`, `NumberOfPieces`, `NumberOfVoxels`, `NumberOfStrayVoxels`,
 * `ExteriorArea`, `CutArea`, `Layer` (1 is the epidermis, 0 none), `Sphericity`, `Elongation`, `Flatness`,
 * `MajorAxisLength`, `MajorAxis`, `MiddleAxisLength`, `MiddleAxis`, `MinorAxisLength`, `MinorAxis`, `MeanCurvature`,
 * `GaussianCurvature`, `MaximumCurvature`, `MinimumCurvature` (of the tissue's surface). The walls': `WallId`,
 * `Label0`, `Label1`, `Area`, `Center`, `Normal` (from the first cell to the second), `Planarity`, `PlaneDistance`,
 * `MeanCurvature`, `CutArea`.
 *
 * In Python a column becomes a NumPy array:
 *
 *     volumes = itk.array_from_vector_container(calculator.GetCellColumn("Volume"))
 *
 * \sa CellWallMesh CellWallMeshEvaluationCalculator
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT CellWallMeshStatisticsCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CellWallMeshStatisticsCalculator);

  using Self = CellWallMeshStatisticsCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CellWallMeshStatisticsCalculator, Object);

  using RealContainer = CellWallMesh::CoordinatesContainer;
  /** The type of arrays of labels. A negative label is stored as its two's complement, as in CellWallMesh. */
  using LabelsContainer = CellWallMesh::LabelsContainer;

  itkSetConstObjectMacro(Mesh, CellWallMesh);
  itkGetConstObjectMacro(Mesh, CellWallMesh);

  /** \throws ExceptionObject where there is no mesh, or it is empty. All methods below do before Compute(). */
  void
  Compute();

  /** The names of the columns, in their order, and for each the narrowest type that holds its numbers: "uint8" of
   * flags, "int32", "int64" or "float64". */
  std::vector<std::string>
  GetCellColumnNames() const;
  std::vector<std::string>
  GetCellColumnTypes() const;
  std::vector<std::string>
  GetWallColumnNames() const;
  std::vector<std::string>
  GetWallColumnTypes() const;

  /** A column, as real numbers: labels beyond 2^53 in size are not exact. \throws ExceptionObject for a name that is
   * none of the columns'. */
  RealContainer::Pointer
  GetCellColumn(const std::string & name) const;
  RealContainer::Pointer
  GetWallColumn(const std::string & name) const;

  /** The label of every cell, and both labels of every wall, exact. */
  LabelsContainer::Pointer
  GetCellLabels() const;
  LabelsContainer::Pointer
  GetWallLabels() const;

  /** What a user should know of single cells (tissue::Remark), in the order of the program's report: the cells' labels,
   * the reasons in one word ("handlesCut"), the values that belong to them, and sentences without their subject. */
  LabelsContainer::Pointer
  GetRemarkLabels() const;
  std::vector<std::string>
  GetRemarkReasons() const;
  RealContainer::Pointer
  GetRemarkValues() const;
  std::vector<std::string>
  GetRemarkTexts() const;

  /** The least angle of a triangle, and within a cell between two triangles, in degrees; the longest edge over the
   * shortest. */
  double
  GetMinimumTriangleAngle() const;
  double
  GetMinimumDihedralAngle() const;
  double
  GetEdgeLengthRatio() const;

protected:
  CellWallMeshStatisticsCalculator();
  ~CellWallMeshStatisticsCalculator() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  /** All that was found. */
  struct Findings;

  const Findings &
  GetFindings() const;

  RealContainer::Pointer
  CopyColumn(const std::vector<tissue::StatisticColumn> & columns, const std::string & name) const;

  CellWallMesh::ConstPointer      m_Mesh;
  std::unique_ptr<const Findings> m_Findings;
};
} // namespace itk

#endif
