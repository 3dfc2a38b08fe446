/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellWallMeshEvaluationCalculator_h
#define itkCellWallMeshEvaluationCalculator_h

#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"
#include "TissueTessellationCore/Evaluation/WallMeshEvaluation.h"
#include "itkCellWallMesh.h"
#include "itkExteriorLabelSettings.h"
#include "itkMultiThreaderBase.h"
#include "itkTissueJunctions.h"
#include "itkTissueLabelVolume.h"

#include <memory>

namespace itk
{
/** \class CellWallMeshEvaluationCalculator
 * \brief Judges a mesh of cell walls, of any origin, by the label image that it is of.
 *
 * Inputs: the mesh, one of this module (SetMesh) or triangles with the labels on their two sides (SetTriangles), in the
 * physical space of the image; and the label image, of any integer type, whose buffer must hold the largest possible
 * region, or what LabelJunctionExtractionFilter has made of it (SetJunctions, SetLabelVolume). Points of the mesh at
 * the very same place are taken for one. Voids that the tissue encloses are the exterior's, as a mesh of any origin
 * knows one exterior.
 *
 * Compute() finds all of tissue::TissueMeshEvaluation, whose comments say what each figure is: adjacency2 and 4, false
 * and missing pairs of neighbours, separate walls, the topology of the exterior, corners of more than four cells,
 * closed cells and their Euler characteristic, volume errors, the walls' distance to those of the image, quality and
 * crossings of the triangles, Dice of the voxels, convexity. The result does not depend on the number of work units.
 *
 * \sa LabelImageToCellWallMeshFilter
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT CellWallMeshEvaluationCalculator : public Object
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CellWallMeshEvaluationCalculator);

  using Self = CellWallMeshEvaluationCalculator;
  using Superclass = Object;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  using LabelImageType = TLabelImage;
  using TrianglesType = std::shared_ptr<const tissue::TrianglesOfLabels>;

  itkNewMacro(Self);
  itkTypeMacro(CellWallMeshEvaluationCalculator, Object);

  itkSetConstObjectMacro(Image, LabelImageType);

  /** In place of SetTriangles(). \throws ExceptionObject where the mesh is empty. */
  void
  SetMesh(const CellWallMesh * mesh);

#ifndef ITK_WRAPPING_PARSER
  /** In place of SetMesh(), for C++. */
  void
  SetTriangles(TrianglesType triangles);
#endif

  /** The junctions and the label volume of the image, of who has them already: both, in place of SetImage(). Default:
   * none, which extracts them from the image. */
  itkSetConstObjectMacro(Junctions, TissueJunctions);
  itkSetConstObjectMacro(LabelVolume, TissueLabelVolume);

  /** ExteriorLabel, AutomaticExteriorLabel, ZeroIsCell, DroppedLabels and DropSuspects, where junctions are extracted:
   * see itkExteriorLabelSettings.h. */
  itkExteriorLabelMacro();

  /** Default: that of MultiThreaderBase. */
  void
  SetNumberOfWorkUnits(ThreadIdType number);
  ThreadIdType
  GetNumberOfWorkUnits() const;

  /** \throws ExceptionObject: no image or mesh; junctions without a label volume, or the other way round; no junctions
   * in the image; a label that the image has not, or on both sides of a triangle; a point that is not finite; a
   * triangle with a point that is not there. */
  void
  Compute();

  /** The main figures of the evaluation, as tissue::TissueMeshEvaluation has them; a mean is -1 where there is nothing
   * to measure. \throws ExceptionObject before Compute(). */
  double
  GetAdjacency2() const;
  double
  GetAdjacency4() const;
  double
  GetAdjacency4OfNeighbors() const;
  SizeValueType
  GetNumberOfFalsePairs() const;
  SizeValueType
  GetNumberOfMissingPairs() const;
  SizeValueType
  GetNumberOfPairsWithSeparateWalls() const;
  SizeValueType
  GetNumberOfKeptPairsWithSeparateWalls() const;
  /** -1 where the mesh is not closed to the exterior. */
  OffsetValueType
  GetGenusOfExterior() const;
  OffsetValueType
  GetGenusOfExteriorInImage() const;
  SizeValueType
  GetNumberOfCells() const;
  SizeValueType
  GetNumberOfClosedCells() const;
  SizeValueType
  GetNumberOfCellsOfSpheres() const;
  SizeValueType
  GetNumberOfCrowdedCorners() const;
  SizeValueType
  GetNumberOfCrossings() const;
  double
  GetMeanVolumeError() const;
  double
  GetMeanWallDistance() const;
  /** From the image's walls to the mesh, and the Hausdorff distance at 95 % (WallDistance). */
  double
  GetMeanWallDistanceFromImage() const;
  double
  GetHausdorffDistance95() const;
  double
  GetMeanTriangleQuality() const;
  /** The least angle of a triangle, and within a cell between two triangles, in degrees. */
  double
  GetMinimumTriangleAngle() const;
  double
  GetMinimumDihedralAngle() const;
  /** The longest edge over the shortest. */
  double
  GetEdgeLengthRatio() const;
  double
  GetMeanDice() const;
  double
  GetMeanConvexity() const;

#ifndef ITK_WRAPPING_PARSER
  /** All that was found, for C++. \throws ExceptionObject before Compute(). */
  const tissue::TissueMeshEvaluation &
  GetEvaluation() const;

  /** The cells by which the evaluation counts, the exterior first: their labels, and what the image has of them.
   * \throws ExceptionObject before Compute(). */
  const std::vector<tissue::Cell> &
  GetCells() const;
#endif

protected:
  CellWallMeshEvaluationCalculator();
  ~CellWallMeshEvaluationCalculator() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  void
  CheckInputs() const;

  void
  Evaluate(const tissue::JunctionSet & junctions, const tissue::LabelVolume & labels);

  typename LabelImageType::ConstPointer m_Image;
  TrianglesType                         m_Triangles;
  TissueJunctions::ConstPointer         m_Junctions;
  TissueLabelVolume::ConstPointer       m_LabelVolume;
  MultiThreaderBase::Pointer            m_MultiThreader;
  ExteriorLabelSettings                 m_Exterior;

  std::vector<tissue::Cell>                           m_Cells;
  std::unique_ptr<const tissue::TissueMeshEvaluation> m_Evaluation;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkCellWallMeshEvaluationCalculator.hxx"
#endif

#endif
