/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkTissueLabelVolume_h
#define itkTissueLabelVolume_h

#include "TissueTessellationExport.h"
#include "itkDataObject.h"
#include "itkObjectFactory.h"

#include <memory>

namespace tissue
{
struct LabelVolume;
}

namespace itk
{
/** \class TissueLabelVolume
 * \brief The label image of a tissue by the vertices of its cells, as an object of the pipeline.
 *
 * Holds a tissue::LabelVolume, whose vertices are those of the TissueJunctions that it is made with: a voxel of a cell
 * has the cell's vertex, one of an enclosed void the void's, and all others the exterior's. It takes 2 bytes a voxel, 4
 * with more than 65535 cells.
 * With it JunctionsToCellWallMeshFilter fits the walls to the image.
 *
 * \sa LabelJunctionExtractionFilter JunctionsToCellWallMeshFilter
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT TissueLabelVolume : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TissueLabelVolume);

  using Self = TissueLabelVolume;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TissueLabelVolume, DataObject);

  /** 0 of a volume that is empty. */
  SizeValueType
  GetNumberOfVoxels() const;

#ifndef ITK_WRAPPING_PARSER
  /** The volume, for C++. \throws ExceptionObject where there is none. */
  const tissue::LabelVolume &
  GetLabelVolume() const;

  void
  SetLabelVolume(std::shared_ptr<const tissue::LabelVolume> volume);
#endif

  /** Lets the volume go. */
  void
  Initialize() override;

  /** Shares the other object's volume. */
  void
  Graft(const DataObject * data) override;

protected:
  TissueLabelVolume() = default;
  ~TissueLabelVolume() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  std::shared_ptr<const tissue::LabelVolume> m_LabelVolume;
};
} // namespace itk

#endif
