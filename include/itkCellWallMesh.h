/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCellWallMesh_h
#define itkCellWallMesh_h

#include "TissueTessellationExport.h"
#include "itkDataObject.h"
#include "itkObjectFactory.h"
#include "itkVectorContainer.h"

#include <memory>

namespace tissue
{
struct AdjacencyOverlap;
struct JunctionSet;
struct TissueReconstruction;
struct WallMesh;
} // namespace tissue

namespace itk
{
/** \class CellWallMesh
 * \brief The triangular mesh of all cell walls of a tissue, with all that is known of its cells, as an object of the
 * pipeline.
 *
 * Holds a tissue::WallMesh (whose class comment is the contract: each wall once, shared by its two cells, normals from
 * the first cell to the second, the exterior always second), the tissue::TissueReconstruction it belongs to and the
 * tissue::JunctionSet it was made from. Positions are in the physical space (LPS) and units of the image.
 *
 * GetPointCoordinates(), GetTriangles() and GetTriangleLabels() copy the mesh to flat arrays, one tuple after the
 * other. In Python they become NumPy arrays:
 *
 *     mesh = itk.label_image_to_cell_wall_mesh_filter(image)
 *     points = itk.array_from_vector_container(mesh.GetPointCoordinates()).reshape(-1, 3)
 *     triangles = itk.array_from_vector_container(mesh.GetTriangles()).reshape(-1, 3)
 *     labels = itk.array_from_vector_container(mesh.GetTriangleLabels()).reshape(-1, 2)
 *
 * \sa LabelImageToCellWallMeshFilter JunctionsToCellWallMeshFilter CellWallMeshStatisticsCalculator
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT CellWallMesh : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(CellWallMesh);

  using Self = CellWallMesh;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(CellWallMesh, DataObject);

  using CoordinatesContainer = VectorContainer<IdentifierType, double>;
  using IndicesContainer = VectorContainer<IdentifierType, IdentifierType>;
  /** The type of the indices, because ITK's Python has arrays of unsigned integers only; a negative label is there as
   * its two's complement (NumPy: `labels.astype(np.int64)`). */
  using LabelsContainer = IndicesContainer;

  SizeValueType
  GetNumberOfPoints() const;

  SizeValueType
  GetNumberOfTriangles() const;

  /** The number of cells in the mesh, the exterior not counted. */
  SizeValueType
  GetNumberOfCells() const;

  /** The coordinates x, y, z of every point. */
  CoordinatesContainer::Pointer
  GetPointCoordinates() const;

  /** The three point indices of every triangle. */
  IndicesContainer::Pointer
  GetTriangles() const;

  /** The two labels that every triangle separates: its normal points from the first to the second. */
  LabelsContainer::Pointer
  GetTriangleLabels() const;

  /** The wall of every triangle, from 0 on; the triangles of a wall follow each other. */
  IndicesContainer::Pointer
  GetTriangleWalls() const;

  /** How many cells, the exterior counted, meet at every point: 2 within a wall, 3 on the line of three, 4 at a corner.
   */
  IndicesContainer::Pointer
  GetNumbersOfCellsAtPoints() const;

  /** The label that stands for the exterior: that of the image, or, if it has none, 0 or a negative one that no cell
   * has. \throws ExceptionObject where the mesh is empty. */
  OffsetValueType
  GetExteriorLabel() const;

  /** The Jaccard indices of the adjacencies of two and of four cells in the optimized complex and in the image (paper,
   * section 4.1), 0 .. 1. */
  double
  GetAdjacency2() const;

  double
  GetAdjacency4() const;

  /** Adjacency4 of those groups of four alone whose six pairs are neighbours in the image. */
  double
  GetAdjacency4OfNeighbors() const;

  /** Pairs of neighbours in the complex but not in the image, and the other way round. */
  SizeValueType
  GetNumberOfFalsePairs() const;
  SizeValueType
  GetNumberOfMissingPairs() const;

  /** Pairs of triangles that cross, of walls that are fitted to an image: it should be 0. */
  SizeValueType
  GetNumberOfCrossings() const;

#ifndef ITK_WRAPPING_PARSER
  /** The reconstruction with all that is known of it, its mesh, and the junctions it was made from, for C++.
   * \throws ExceptionObject where there is none yet. */
  const tissue::TissueReconstruction &
  GetReconstruction() const;

  const tissue::WallMesh &
  GetWallMesh() const;

  const tissue::JunctionSet &
  GetJunctionSet() const;

  void
  SetReconstruction(std::shared_ptr<const tissue::JunctionSet>          junctions,
                    std::shared_ptr<const tissue::TissueReconstruction> reconstruction);
#endif

  /** Empties the mesh. */
  void
  Initialize() override;

  /** Shares the other mesh's content. */
  void
  Graft(const DataObject * data) override;

protected:
  CellWallMesh() = default;
  ~CellWallMesh() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  const tissue::AdjacencyOverlap &
  GetOverlap() const;

  std::shared_ptr<const tissue::JunctionSet>          m_JunctionSet;
  std::shared_ptr<const tissue::TissueReconstruction> m_Reconstruction;
};
} // namespace itk

#endif
