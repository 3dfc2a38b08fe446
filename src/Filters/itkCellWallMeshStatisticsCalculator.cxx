/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkCellWallMeshStatisticsCalculator.h"

#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include <algorithm>
#include <type_traits>

namespace itk
{
struct CellWallMeshStatisticsCalculator::Findings
{
  /** Of the cells without the row of the exterior. */
  std::vector<tissue::StatisticColumn> cells;
  std::vector<tissue::StatisticColumn> walls;
  std::vector<tissue::CellRemark>      remarks;
  tissue::WallAngles                   angles;
};

namespace
{
using Columns = std::vector<tissue::StatisticColumn>;

void
RemoveFirstRow(Columns & columns)
{
  for (tissue::StatisticColumn & column : columns)
  {
    const int components = column.numberOfComponents;
    std::visit([&](auto & values) { values.erase(values.begin(), values.begin() + components); }, column.values);
  }
}

std::vector<std::string>
NamesOf(const Columns & columns)
{
  std::vector<std::string> names;
  for (const tissue::StatisticColumn & column : columns)
  {
    names.push_back(column.name);
  }
  return names;
}

std::vector<std::string>
TypesOf(const Columns & columns)
{
  std::vector<std::string> types;
  for (const tissue::StatisticColumn & column : columns)
  {
    const char * const names[] = { "uint8", "int32", "int64", "float64" };
    static_assert(std::variant_size_v<tissue::StatisticColumn::Values> == 4, "Each type has a name.");
    types.push_back(names[column.values.index()]);
  }
  return types;
}

template <typename TRow, typename TValueOf>
std::vector<std::string>
ToStrings(const std::vector<TRow> & rows, const TValueOf & valueOf)
{
  std::vector<std::string> strings;
  std::transform(rows.begin(), rows.end(), std::back_inserter(strings), valueOf);
  return strings;
}
} // namespace

CellWallMeshStatisticsCalculator::CellWallMeshStatisticsCalculator() = default;

CellWallMeshStatisticsCalculator::~CellWallMeshStatisticsCalculator() = default;

void
CellWallMeshStatisticsCalculator::Compute()
{
  if (!m_Mesh)
  {
    itkExceptionMacro("No mesh is set.");
  }
  const tissue::WallMesh &    walls = m_Mesh->GetWallMesh();
  const tissue::JunctionSet & junctions = m_Mesh->GetJunctionSet();
  const auto                  check = tissue::CheckCellSurfaces(walls, junctions.NumberOfVertices());
  const auto                  statistics = tissue::MeasureTissue(walls, junctions.cells, junctions.grid);
  auto                        findings = std::make_unique<Findings>();
  findings->cells = tissue::MakeCellColumns(walls, junctions.cells, check, statistics);
  RemoveFirstRow(findings->cells);
  findings->walls = tissue::MakeWallColumns(walls, junctions.cells, statistics);
  findings->remarks = tissue::CollectRemarks(check);
  const auto & remarks = m_Mesh->GetReconstruction().remarks;
  findings->remarks.insert(findings->remarks.end(), remarks.begin(), remarks.end());
  findings->angles = check.angles;
  m_Findings = std::move(findings);
}

const CellWallMeshStatisticsCalculator::Findings &
CellWallMeshStatisticsCalculator::GetFindings() const
{
  if (!m_Findings)
  {
    itkExceptionMacro("Nothing is known before Compute().");
  }
  return *m_Findings;
}

std::vector<std::string>
CellWallMeshStatisticsCalculator::GetCellColumnNames() const
{
  return NamesOf(this->GetFindings().cells);
}

std::vector<std::string>
CellWallMeshStatisticsCalculator::GetCellColumnTypes() const
{
  return TypesOf(this->GetFindings().cells);
}

std::vector<std::string>
CellWallMeshStatisticsCalculator::GetWallColumnNames() const
{
  return NamesOf(this->GetFindings().walls);
}

std::vector<std::string>
CellWallMeshStatisticsCalculator::GetWallColumnTypes() const
{
  return TypesOf(this->GetFindings().walls);
}

CellWallMeshStatisticsCalculator::RealContainer::Pointer
CellWallMeshStatisticsCalculator::CopyColumn(const Columns & columns, const std::string & name) const
{
  const auto column = std::find_if(
    columns.begin(), columns.end(), [&](const tissue::StatisticColumn & candidate) { return candidate.name == name; });
  if (column == columns.end())
  {
    std::string names;
    for (const std::string & known : NamesOf(columns))
    {
      names += (names.empty() ? "" : ", ") + known;
    }
    itkExceptionMacro("There is no column " << name << ": there are " << names);
  }
  const auto container = RealContainer::New();
  std::visit([&](const auto & values) { container->CastToSTLContainer().assign(values.begin(), values.end()); },
             column->values);
  return container;
}

CellWallMeshStatisticsCalculator::RealContainer::Pointer
CellWallMeshStatisticsCalculator::GetCellColumn(const std::string & name) const
{
  return this->CopyColumn(this->GetFindings().cells, name);
}

CellWallMeshStatisticsCalculator::RealContainer::Pointer
CellWallMeshStatisticsCalculator::GetWallColumn(const std::string & name) const
{
  return this->CopyColumn(this->GetFindings().walls, name);
}

CellWallMeshStatisticsCalculator::LabelsContainer::Pointer
CellWallMeshStatisticsCalculator::GetCellLabels() const
{
  this->GetFindings();
  const auto   container = LabelsContainer::New();
  const auto & cells = m_Mesh->GetJunctionSet().cells;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    container->push_back(static_cast<IdentifierType>(cells[v].label));
  }
  return container;
}

CellWallMeshStatisticsCalculator::LabelsContainer::Pointer
CellWallMeshStatisticsCalculator::GetWallLabels() const
{
  this->GetFindings();
  const auto container = LabelsContainer::New();
  for (const tissue::WallMesh::Wall & wall : m_Mesh->GetWallMesh().walls)
  {
    for (const tissue::VertexId cell : wall.cells)
    {
      container->push_back(static_cast<IdentifierType>(m_Mesh->GetJunctionSet().CellOfVertex(cell).label));
    }
  }
  return container;
}

CellWallMeshStatisticsCalculator::LabelsContainer::Pointer
CellWallMeshStatisticsCalculator::GetRemarkLabels() const
{
  const auto container = LabelsContainer::New();
  for (const tissue::CellRemark & remark : this->GetFindings().remarks)
  {
    container->push_back(static_cast<IdentifierType>(m_Mesh->GetJunctionSet().CellOfVertex(remark.cell).label));
  }
  return container;
}

std::vector<std::string>
CellWallMeshStatisticsCalculator::GetRemarkReasons() const
{
  return ToStrings(this->GetFindings().remarks,
                   [](const tissue::CellRemark & remark) { return tissue::ToString(remark.remark); });
}

CellWallMeshStatisticsCalculator::RealContainer::Pointer
CellWallMeshStatisticsCalculator::GetRemarkValues() const
{
  const auto container = RealContainer::New();
  for (const tissue::CellRemark & remark : this->GetFindings().remarks)
  {
    container->push_back(remark.value);
  }
  return container;
}

std::vector<std::string>
CellWallMeshStatisticsCalculator::GetRemarkTexts() const
{
  return ToStrings(this->GetFindings().remarks,
                   [](const tissue::CellRemark & remark) { return tissue::Describe(remark); });
}

double
CellWallMeshStatisticsCalculator::GetMinimumTriangleAngle() const
{
  return this->GetFindings().angles.minimumTriangleAngle;
}

double
CellWallMeshStatisticsCalculator::GetMinimumDihedralAngle() const
{
  return this->GetFindings().angles.minimumDihedralAngle;
}

double
CellWallMeshStatisticsCalculator::GetEdgeLengthRatio() const
{
  return this->GetFindings().angles.EdgeLengthRatio();
}

void
CellWallMeshStatisticsCalculator::PrintSelf(std::ostream & os, Indent indent) const
{
  Superclass::PrintSelf(os, indent);
  os << indent << "Mesh: " << m_Mesh.GetPointer() << std::endl;
  os << indent << "Computed: " << (m_Findings ? "yes" : "no") << std::endl;
}
} // namespace itk
