/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkTissueJunctions.h"

namespace itk
{
template <typename TVertices>
void
TissueJunctions::AppendLabels(const TVertices & vertices, LabelsContainer & container) const
{
  for (const tissue::VertexId v : vertices)
  {
    container.push_back(static_cast<IdentifierType>(m_JunctionSet.cells[v].label));
  }
}

TissueJunctions::LabelsContainer::Pointer
TissueJunctions::GetCellLabels() const
{
  const auto container = LabelsContainer::New();
  for (std::size_t cell = 1; cell < m_JunctionSet.cells.size(); ++cell)
  {
    container->push_back(static_cast<IdentifierType>(m_JunctionSet.cells[cell].label));
  }
  return container;
}

TissueJunctions::RealContainer::Pointer
TissueJunctions::GetCellCenters() const
{
  const auto container = RealContainer::New();
  for (std::size_t cell = 1; cell < m_JunctionSet.cells.size(); ++cell)
  {
    for (const double coordinate : m_JunctionSet.cells[cell].center)
    {
      container->push_back(coordinate);
    }
  }
  return container;
}

TissueJunctions::RealContainer::Pointer
TissueJunctions::GetCellVolumes() const
{
  const auto container = RealContainer::New();
  for (std::size_t cell = 1; cell < m_JunctionSet.cells.size(); ++cell)
  {
    container->push_back(m_JunctionSet.cells[cell].volume);
  }
  return container;
}

TissueJunctions::LabelsContainer::Pointer
TissueJunctions::GetWallLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::Wall & wall : m_JunctionSet.walls)
  {
    this->AppendLabels(wall.cells, *container);
  }
  return container;
}

TissueJunctions::RealContainer::Pointer
TissueJunctions::GetWallAreas() const
{
  const auto container = RealContainer::New();
  for (const tissue::Wall & wall : m_JunctionSet.walls)
  {
    container->push_back(wall.area);
  }
  return container;
}

TissueJunctions::LabelsContainer::Pointer
TissueJunctions::GetJunctionLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::Junction & junction : m_JunctionSet.junctions)
  {
    this->AppendLabels(junction.cells, *container);
  }
  return container;
}

TissueJunctions::RealContainer::Pointer
TissueJunctions::GetJunctionPositions() const
{
  const auto container = RealContainer::New();
  for (const tissue::Junction & junction : m_JunctionSet.junctions)
  {
    for (const double coordinate : junction.position)
    {
      container->push_back(coordinate);
    }
  }
  return container;
}

void
TissueJunctions::Initialize()
{
  Superclass::Initialize();
  m_JunctionSet = tissue::JunctionSet();
}

void
TissueJunctions::Graft(const DataObject * data)
{
  const auto * other = dynamic_cast<const Self *>(data);
  if (other == nullptr)
  {
    itkExceptionMacro(<< "Only another TissueJunctions can be grafted onto this one.");
  }
  m_JunctionSet = other->m_JunctionSet;
}

void
TissueJunctions::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Cells, the exterior counted: " << m_JunctionSet.cells.size() << std::endl;
  os << indent << "Walls: " << m_JunctionSet.walls.size() << std::endl;
  os << indent << "Triple lines: " << m_JunctionSet.tripleLines.size() << std::endl;
  os << indent << "Junctions: " << m_JunctionSet.junctions.size() << std::endl;
}
} // namespace itk
