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
#include "TissueTessellationCore/JunctionSet.h"

namespace itk
{
/** \class TissueJunctions
 * \brief Cells, walls, triple lines and junctions of a tissue as an object of the pipeline.
 *
 * Holds a tissue::JunctionSet, whose comments say what is in it. Positions, areas and volumes are in the physical space
 * of the image they were extracted from.
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
  tissue::JunctionSet m_JunctionSet;
};
} // namespace itk

#endif
