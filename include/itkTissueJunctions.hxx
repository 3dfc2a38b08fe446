/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkTissueJunctions_hxx
#define itkTissueJunctions_hxx

#include "itkTissueJunctions.h"

namespace itk
{
template <typename TVertices>
void
TissueJunctions::AppendLabels(const TVertices & vertices, LabelsContainer & container) const
{
  for (const tissue::VertexId v : vertices)
  {
    container.push_back(static_cast<IdentifierType>(m_JunctionSet.CellOfVertex(v).label));
  }
}

inline TissueJunctions::LabelsContainer::Pointer
TissueJunctions::GetCellLabels() const
{
  const auto container = LabelsContainer::New();
  for (std::size_t cell = 1; cell < m_JunctionSet.cells.size(); ++cell)
  {
    container->push_back(static_cast<IdentifierType>(m_JunctionSet.cells[cell].label));
  }
  return container;
}

inline TissueJunctions::RealContainer::Pointer
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

inline TissueJunctions::RealContainer::Pointer
TissueJunctions::GetCellVolumes() const
{
  const auto container = RealContainer::New();
  for (std::size_t cell = 1; cell < m_JunctionSet.cells.size(); ++cell)
  {
    container->push_back(m_JunctionSet.cells[cell].volume);
  }
  return container;
}

inline TissueJunctions::LabelsContainer::Pointer
TissueJunctions::GetWallLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::Wall & wall : m_JunctionSet.walls)
  {
    this->AppendLabels(wall.cells, *container);
  }
  return container;
}

inline TissueJunctions::RealContainer::Pointer
TissueJunctions::GetWallAreas() const
{
  const auto container = RealContainer::New();
  for (const tissue::Wall & wall : m_JunctionSet.walls)
  {
    container->push_back(wall.area);
  }
  return container;
}

inline TissueJunctions::LabelsContainer::Pointer
TissueJunctions::GetJunctionLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::Junction & junction : m_JunctionSet.junctions)
  {
    this->AppendLabels(junction.cells, *container);
  }
  return container;
}

inline TissueJunctions::RealContainer::Pointer
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
} // namespace itk

#endif
