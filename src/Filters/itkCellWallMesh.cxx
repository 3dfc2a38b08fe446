/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkCellWallMesh.h"

#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

namespace itk
{
const tissue::TissueReconstruction &
CellWallMesh::GetReconstruction() const
{
  if (!m_Reconstruction)
  {
    itkExceptionMacro("The mesh is empty: the filter that makes it has not been updated.");
  }
  return *m_Reconstruction;
}

const tissue::WallMesh &
CellWallMesh::GetWallMesh() const
{
  return this->GetReconstruction().walls;
}

const tissue::JunctionSet &
CellWallMesh::GetJunctionSet() const
{
  if (!m_JunctionSet)
  {
    itkExceptionMacro("The mesh is empty: the filter that makes it has not been updated.");
  }
  return *m_JunctionSet;
}

SizeValueType
CellWallMesh::GetNumberOfPoints() const
{
  return m_Reconstruction ? m_Reconstruction->walls.points.size() : 0;
}

SizeValueType
CellWallMesh::GetNumberOfTriangles() const
{
  return m_Reconstruction ? m_Reconstruction->walls.triangles.size() : 0;
}

SizeValueType
CellWallMesh::GetNumberOfCells() const
{
  return m_JunctionSet ? m_JunctionSet->cells.size() - 1 : 0;
}

CellWallMesh::CoordinatesContainer::Pointer
CellWallMesh::GetPointCoordinates() const
{
  const auto container = CoordinatesContainer::New();
  for (const tissue::Point & point : this->GetWallMesh().points)
  {
    for (const double coordinate : point)
    {
      container->push_back(coordinate);
    }
  }
  return container;
}

CellWallMesh::IndicesContainer::Pointer
CellWallMesh::GetTriangles() const
{
  const auto container = IndicesContainer::New();
  for (const auto & triangle : this->GetWallMesh().triangles)
  {
    for (const tissue::PointId point : triangle)
    {
      container->push_back(static_cast<IdentifierType>(point));
    }
  }
  return container;
}

CellWallMesh::LabelsContainer::Pointer
CellWallMesh::GetTriangleLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::WallId wall : this->GetWallMesh().wallOfTriangle)
  {
    for (const tissue::VertexId cell : this->GetWallMesh().walls[wall].cells)
    {
      container->push_back(static_cast<IdentifierType>(this->GetJunctionSet().cells[cell].label));
    }
  }
  return container;
}

CellWallMesh::IndicesContainer::Pointer
CellWallMesh::GetTriangleWalls() const
{
  const auto container = IndicesContainer::New();
  for (const tissue::WallId wall : this->GetWallMesh().wallOfTriangle)
  {
    container->push_back(static_cast<IdentifierType>(wall));
  }
  return container;
}

CellWallMesh::IndicesContainer::Pointer
CellWallMesh::GetNumbersOfCellsAtPoints() const
{
  const auto container = IndicesContainer::New();
  for (const std::uint8_t number : this->GetWallMesh().numberOfCells)
  {
    container->push_back(number);
  }
  return container;
}

OffsetValueType
CellWallMesh::GetExteriorLabel() const
{
  return static_cast<OffsetValueType>(this->GetJunctionSet().CellOfVertex(tissue::ExteriorVertex).label);
}

const tissue::AdjacencyOverlap &
CellWallMesh::GetOverlap() const
{
  return this->GetReconstruction().stages.back().statistics.overlap;
}

double
CellWallMesh::GetAdjacency2() const
{
  return this->GetOverlap().adjacency2;
}

double
CellWallMesh::GetAdjacency4() const
{
  return this->GetOverlap().adjacency4;
}

double
CellWallMesh::GetAdjacency4OfNeighbors() const
{
  return this->GetOverlap().adjacency4OfNeighbors;
}

SizeValueType
CellWallMesh::GetNumberOfFalsePairs() const
{
  return static_cast<SizeValueType>(this->GetOverlap().numberOfFalsePairs);
}

SizeValueType
CellWallMesh::GetNumberOfMissingPairs() const
{
  return static_cast<SizeValueType>(this->GetOverlap().numberOfMissingPairs);
}

SizeValueType
CellWallMesh::GetNumberOfCrossings() const
{
  return static_cast<SizeValueType>(this->GetReconstruction().fitting.crossingPairs);
}

void
CellWallMesh::SetReconstruction(std::shared_ptr<const tissue::JunctionSet>          junctions,
                                std::shared_ptr<const tissue::TissueReconstruction> reconstruction)
{
  m_JunctionSet = std::move(junctions);
  m_Reconstruction = std::move(reconstruction);
  this->Modified();
}

void
CellWallMesh::Initialize()
{
  Superclass::Initialize();
  m_JunctionSet.reset();
  m_Reconstruction.reset();
}

void
CellWallMesh::Graft(const DataObject * data)
{
  const auto * const other = dynamic_cast<const Self *>(data);
  if (!other)
  {
    itkExceptionMacro("Only another CellWallMesh can be grafted onto this one.");
  }
  m_JunctionSet = other->m_JunctionSet;
  m_Reconstruction = other->m_Reconstruction;
}

void
CellWallMesh::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Points: " << this->GetNumberOfPoints() << std::endl;
  os << indent << "Triangles: " << this->GetNumberOfTriangles() << std::endl;
  os << indent << "Cells: " << this->GetNumberOfCells() << std::endl;
}
} // namespace itk
