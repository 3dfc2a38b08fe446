/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkTissueJunctions_h
#define itkTissueJunctions_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationExport.h"
#include "itkDataObject.h"
#include "itkObjectFactory.h"
#include "itkVectorContainer.h"

namespace itk
{
/** \class TissueJunctions
 * \brief Cells, walls, triple lines and junctions of a tissue as an object of the pipeline.
 *
 * Holds a tissue::JunctionSet, whose comments say what is in it. Positions, areas and volumes are in the physical space
 * of the image they were extracted from.
 *
 * The methods that return containers copy what they are named after to flat arrays, one tuple after the other. In
 * Python they become NumPy arrays:
 *
 *     positions = itk.array_from_vector_container(junctions.GetJunctionPositions()).reshape(-1, 3)
 *     labels = itk.array_from_vector_container(junctions.GetJunctionLabels()).reshape(-1, 4)
 *
 * \sa LabelJunctionExtractionFilter
 * \ingroup TissueTessellation
 */
class TissueTessellation_EXPORT TissueJunctions : public DataObject
{
public:
  ITK_DISALLOW_COPY_AND_MOVE(TissueJunctions);

  using Self = TissueJunctions;
  using Superclass = DataObject;
  using Pointer = SmartPointer<Self>;
  using ConstPointer = SmartPointer<const Self>;

  itkNewMacro(Self);
  itkTypeMacro(TissueJunctions, DataObject);

  using RealContainer = VectorContainer<IdentifierType, double>;
  /** The type of arrays of labels. A negative label is stored as its two's complement, as in CellWallMesh. */
  using LabelsContainer = VectorContainer<IdentifierType, IdentifierType>;

  /** The label, the centre x, y, z, and the volume of every cell, without the exterior. */
  LabelsContainer::Pointer
  GetCellLabels() const;
  RealContainer::Pointer
  GetCellCenters() const;
  RealContainer::Pointer
  GetCellVolumes() const;

  /** The labels of the two cells of every wall, the exterior's first, and the wall's area. */
  LabelsContainer::Pointer
  GetWallLabels() const;
  RealContainer::Pointer
  GetWallAreas() const;

  /** The labels of the four cells of every junction, and the junction's position x, y, z. */
  LabelsContainer::Pointer
  GetJunctionLabels() const;
  RealContainer::Pointer
  GetJunctionPositions() const;

#ifndef ITK_WRAPPING_PARSER
  /** The whole set, for C++. */
  const tissue::JunctionSet &
  GetJunctionSet() const
  {
    return m_JunctionSet;
  }

  void
  SetJunctionSet(tissue::JunctionSet junctionSet)
  {
    m_JunctionSet = std::move(junctionSet);
    this->Modified();
  }
#endif

  /** Empties the set. */
  void
  Initialize() override;

  void
  Graft(const DataObject * data) override;

protected:
  TissueJunctions() = default;
  ~TissueJunctions() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override;

private:
  template <typename TVertices>
  void
  AppendLabels(const TVertices & vertices, LabelsContainer & container) const;

  tissue::JunctionSet m_JunctionSet;
};
} // namespace itk

#endif
