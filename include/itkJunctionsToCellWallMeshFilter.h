/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkJunctionsToCellWallMeshFilter_h
#define itkJunctionsToCellWallMeshFilter_h

#include "TissueTessellationExport.h"
#include "itkCellWallMeshSource.h"
#include "itkTissueLabelVolume.h"

namespace itk
{
class TissueJunctions;

/** \class JunctionsToCellWallMeshFilter
 * \brief Makes the mesh of all cell walls of a tissue from the junctions of its label image.
 *
 * The adjacency complex of the cells starts as the Delaunay tetrahedralization of their centres with a vertex for the
 * exterior, loses its oversized surface triangles, and is optimized by edge removals and triangle swaps; its dual is
 * the mesh (G. Cerutti et al., 3-D tessellation of plant tissue, 3DV 2015,
 * doi:10.1109/3DV.2015.57, sections 3 and 4.2). It is a closed surface for every cell, and at most four cells meet at
 * any point.
 *
 * With the label volume of the junctions as the second input the walls are fitted to the image:
 *
 *     extraction->GenerateLabelVolumeOn();
 *     filter->SetInput(extraction->GetOutput());
 *     filter->SetLabelVolume(extraction->GetLabelVolume());
 *
 * Progress is that of the whole; the filter can be aborted. Throws ExceptionObject for fewer than four cells, for cells
 * whose centres are coplanar, for parameters out of range, and for a label volume that is empty.
 *
 * \sa LabelJunctionExtractionFilter LabelImageToCellWallMeshFilter
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT JunctionsToCellWallMeshFilter : public CellWallMeshSource
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(JunctionsToCellWallMeshFilter);

  using Self = JunctionsToCellWallMeshFilter;
  using Superclass = CellWallMeshSource;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(JunctionsToCellWallMeshFilter, CellWallMeshSource);

  using Superclass::SetInput;
  void
  SetInput(const TissueJunctions * junctions);

  const TissueJunctions *
  GetInput() const;

  /** Optional: the label volume that LabelJunctionExtractionFilter makes with the junctions. The walls are fitted to
   * it; without one they are smoothed stars. */
  itkSetInputMacro(LabelVolume, TissueLabelVolume);
  itkGetInputMacro(LabelVolume, TissueLabelVolume);

protected:
  JunctionsToCellWallMeshFilter();
  ~JunctionsToCellWallMeshFilter() override = default;

  void
  GenerateData() override;
};
} // namespace itk

#endif
