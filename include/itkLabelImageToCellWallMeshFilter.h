/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelImageToCellWallMeshFilter_h
#define itkLabelImageToCellWallMeshFilter_h

#include "TissueTessellationCore/Common/Types.h"
#include "itkCellWallMeshSource.h"

namespace itk
{
/** \class LabelImageToCellWallMeshFilter
 * \brief From a segmented image of a tissue to the mesh of all its cell walls, in one filter.
 *
 * The mini-pipeline:
 *
 *     label image -> LabelJunctionExtractionFilter -> JunctionsToCellWallMeshFilter -> cell-wall mesh
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

  /** The exterior's label; to set it turns AutomaticExteriorLabel off. */
  void
  SetExteriorLabel(tissue::Label label);
  itkGetConstMacro(ExteriorLabel, tissue::Label);

  /** Find the exterior's label in the image: see LabelJunctionExtractionFilter. Default: on. */
  itkSetMacro(AutomaticExteriorLabel, bool);
  itkGetConstMacro(AutomaticExteriorLabel, bool);
  itkBooleanMacro(AutomaticExteriorLabel);

  /** Take label 0 for a cell, if it is not the exterior's. Default: off. */
  itkSetMacro(ZeroIsCell, bool);
  itkGetConstMacro(ZeroIsCell, bool);
  itkBooleanMacro(ZeroIsCell);

protected:
  LabelImageToCellWallMeshFilter();
  ~LabelImageToCellWallMeshFilter() override = default;

  void
  GenerateData() override;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  tissue::Label m_ExteriorLabel = 0;
  bool          m_AutomaticExteriorLabel = true;
  bool          m_ZeroIsCell = false;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkLabelImageToCellWallMeshFilter.hxx"
#endif

#endif
