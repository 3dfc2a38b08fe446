/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkTissueJunctions_h
#define itkTissueJunctions_h

#include "itkDataObject.h"
#include "itkObjectFactory.h"
#include "itkVectorContainer.h"
#include "TissueTessellationCore/JunctionSet.h"

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
class TissueJunctions : public DataObject
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
  /** A negative label is there as its two's complement, as in CellWallMesh. */
  using LabelsContainer = VectorContainer<IdentifierType, IdentifierType>;

  /** Of every cell, the exterior not counted: its label, its centre x, y, z, and its volume. */
  LabelsContainer::Pointer
  GetCellLabels() const;
  RealContainer::Pointer
  GetCellCenters() const;
  RealContainer::Pointer
  GetCellVolumes() const;

  /** Of every wall: the labels of its two cells, the exterior's first, and its area. */
  LabelsContainer::Pointer
  GetWallLabels() const;
  RealContainer::Pointer
  GetWallAreas() const;

  /** Of every junction: the labels of its four cells, and its position x, y, z. */
  LabelsContainer::Pointer
  GetJunctionLabels() const;
  RealContainer::Pointer
  GetJunctionPositions() const;

#ifndef ITK_WRAPPING_PARSER
  /** All that was found, for C++. */
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
  Initialize() override
  {
    Superclass::Initialize();
    m_JunctionSet = tissue::JunctionSet();
  }

  void
  Graft(const DataObject * data) override
  {
    const auto * other = dynamic_cast<const Self *>(data);
    if (other == nullptr)
    {
      itkExceptionMacro(<< "Only another TissueJunctions can be grafted onto this one.");
    }
    m_JunctionSet = other->m_JunctionSet;
  }

protected:
  TissueJunctions() = default;
  ~TissueJunctions() override = default;

  void
  PrintSelf(std::ostream & os, Indent indent) const override
  {
    Superclass::PrintSelf(os, indent);
    os << indent << "Cells, the exterior counted: " << m_JunctionSet.cells.size() << std::endl;
    os << indent << "Walls: " << m_JunctionSet.walls.size() << std::endl;
    os << indent << "Triple lines: " << m_JunctionSet.tripleLines.size() << std::endl;
    os << indent << "Junctions: " << m_JunctionSet.junctions.size() << std::endl;
  }

private:
  template <typename TVertices>
  void
  AppendLabels(const TVertices & vertices, LabelsContainer & container) const;

  tissue::JunctionSet m_JunctionSet;
};
} // namespace itk

#ifndef ITK_MANUAL_INSTANTIATION
#  include "itkTissueJunctions.hxx"
#endif

#endif
