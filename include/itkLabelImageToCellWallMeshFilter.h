/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelImageToCellWallMeshFilter_h
#define itkLabelImageToCellWallMeshFilter_h

#include "itkCellWallMeshSource.h"
#include "itkExteriorLabelSettings.h"
#include "itkTissueVotes.h"

namespace itk
{
/** \class LabelImageToCellWallMeshFilter
 * \brief From a segmented image of a tissue to the mesh of all its cell walls, in one filter.
 *
 * The mini-pipeline:
 *
 *     label image -> LabelJunctionExtractionFilter -> junctions, label volume -> JunctionsToCellWallMeshFilter -> mesh
 *
 * See the two filters for what they do, require and throw. The input is any 3-D image of an integer pixel type, one
 * label for each cell and one for the exterior; spacing, origin and direction are applied.
 *
 * \ingroup TissueTessellation
 */
template <typename TLabelImage>
class ITK_TEMPLATE_EXPORT LabelImageToCellWallMeshFilter : public CellWallMeshSource
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(LabelImageToCellWallMeshFilter);

  using Self = LabelImageToCellWallMeshFilter;
  using Superclass = CellWallMeshSource;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(LabelImageToCellWallMeshFilter, CellWallMeshSource);

  using LabelImageType = TLabelImage;

  void
  SetInput(const LabelImageType * image);

  const LabelImageType *
  GetInput() const;

  /** The votes on which cells meet that PointSetToTissueLabelImageFilter makes with the image. Default: none, which
   * takes the image at its word. */
  itkSetInputMacro(Votes, TissueVotes);
  itkGetInputMacro(Votes, TissueVotes);

  /** ExteriorLabel, AutomaticExteriorLabel, ZeroIsCell, DroppedLabels, DropSuspects: see itkExteriorLabelSettings.h. */
  itkExteriorLabelMacro();

protected:
  LabelImageToCellWallMeshFilter();
  ~LabelImageToCellWallMeshFilter() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  ExteriorLabelSettings m_Exterior;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelImageToCellWallMeshFilter.hxx"
#endif

#endif
