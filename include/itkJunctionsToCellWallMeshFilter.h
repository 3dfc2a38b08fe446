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
 * The adjacency complex of the cells is taken from the label volume, the second input: its corners are the tetrahedra,
 * with every wall as often as the image has it. Its dual is the mesh, with a closed surface for every cell and at most
 * four cells at any point, and is fitted to the image:
 *
 *     extraction->GenerateLabelVolumeOn();
 *     filter->SetInput(extraction->GetOutput());
 *     filter->SetLabelVolume(extraction->GetLabelVolume());
 *
 * By UsePaperPreset() the complex starts as the Delaunay tetrahedralization of the cells' centres with a vertex for the
 * exterior, loses its oversized surface triangles, and is optimized by edge removals and triangle swaps; walls are
 * smoothed stars (G. Cerutti et al., 3-D tessellation of plant tissue, 3DV 2015, doi:10.1109/3DV.2015.57, sections 3
 * and 4.2). It needs no label volume.
 *
 * Progress is that of the whole; the filter can be aborted. Throws ExceptionObject for parameters out of range, for a
 * label volume that is missing or empty, and, by the paper's preset, for fewer than four cells and for cells whose
 * centres are coplanar.
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

  /** The label volume that LabelJunctionExtractionFilter makes with the junctions. The paper's preset needs none. */
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
