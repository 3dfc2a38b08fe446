/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Projection/Projection.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Points/PointColumnName.h"
#include "itkCellSignalCalculator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tissue
{
namespace
{
/** The first of a list, for a message. */
template <typename TValue, typename TToText>
std::string
ListFirst(const std::vector<TValue> & values, const TToText & toText)
{
  constexpr std::size_t most = 5;
  std::string           text;
  for (std::size_t i = 0; i < std::min(values.size(), most); ++i)
  {
    text += (i > 0 ? ", " : "") + toText(values[i]);
  }
  return text + (values.size() > most ? ", ..." : "");
}

std::string
ListLabels(const std::vector<Label> & labels)
{
  return ListFirst(labels, [](Label label) { return std::to_string(label); });
}

/** The values of the rows that the vertices have. */
CellColumn
ToCellColumn(const CellTable::Column & column, const std::vector<std::ptrdiff_t> & rowOfVertex)
{
  CellColumn result{ column.name, {}, {} };
  for (const std::ptrdiff_t row : rowOfVertex)
  {
    if (!column.texts.empty())
    {
      result.texts.push_back(row < 0 ? std::string() : column.texts[static_cast<std::size_t>(row)]);
    }
    else
    {
      result.numbers.push_back(row < 0 ? UnknownStatistic : column.numbers[static_cast<std::size_t>(row)]);
    }
  }
  return result;
}

CellColumn
ToCellColumn(const std::string & name, const std::vector<CellSignal> & signals, double CellSignal::*member)
{
  CellColumn column{ name, {}, {} };
  for (const CellSignal & signal : signals)
  {
    column.numbers.push_back(signal.*member);
  }
  return column;
}

/** Cells of which nothing, and of which not all, is in an image. */
struct Coverage
{
  std::vector<Label> without;
  std::vector<Label> partly;
};

Coverage
FindCoverage(const std::vector<CellSignal> & signals, const std::vector<Cell> & cells)
{
  // An image of another grid has not just as many voxels in a cell.
  constexpr double nearlyAll = 0.95;
  Coverage         coverage;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    const bool isWithout = !(signals[v].knownVolume > 0.0);
    if (isWithout || signals[v].knownVolume < nearlyAll * cells[v].volume)
    {
      (isWithout ? coverage.without : coverage.partly).push_back(cells[v].label);
    }
  }
  return coverage;
}

std::string
CountCells(std::size_t number)
{
  return std::to_string(number) + (number == 1 ? " cell" : " cells");
}
} // namespace

Projection::Projection(ProjectionSources sources, double wallDistance, const std::vector<Cell> & cells,
                       const std::map<Label, std::string> & names, itk::TissueLabelVolume::Pointer labels,
                       const std::string & unit)
  : m_Sources(std::move(sources))
  , m_WallDistance(wallDistance)
  , m_Warnings(m_Sources.Warnings())
{
  this->MatchTables(cells, names);
  for (const ProjectionSources::Signal & signal : m_Sources.signals)
  {
    WithFileName(signal.source.file, [&] {
      if (!labels)
      {
        throw std::runtime_error("a signal needs a label image, which there is none of");
      }
      if (!unit.empty() && !signal.image.unit.empty() && signal.image.unit != unit)
      {
        throw std::runtime_error("the image is in " + signal.image.unit + ", the tissue in " + unit);
      }
      RequireOverlap(signal.image.image, labels->GetLabelVolume(), cells.size());
    });
    m_Labels = labels;
  }
}

void
Projection::MatchTables(const std::vector<Cell> & cells, const std::map<Label, std::string> & names)
{
  for (const ProjectionSources::Table & table : m_Sources.tables)
  {
    const MatchedRows rows = WithFileName(table.file, [&] { return MatchRows(table.values, cells, names); });
    if (!rows.unknownLabels.empty())
    {
      m_Warnings.push_back(table.file + ": " + std::to_string(rows.unknownLabels.size()) + " of " +
                           std::to_string(table.values.names.size()) + " rows have labels that no cell has (" +
                           ListFirst(rows.unknownLabels, QuoteName) + ")");
    }
    if (!rows.cellsWithoutRow.empty())
    {
      m_Warnings.push_back(table.file + ": " + CountCells(rows.cellsWithoutRow.size()) + " of " +
                           std::to_string(cells.size() - 1) + " have no row (labels " +
                           ListLabels(rows.cellsWithoutRow) + "); their values are not known");
    }
    nlohmann::ordered_json columns = nlohmann::ordered_json::array();
    for (const CellTable::Column & column : table.values.columns)
    {
      columns.push_back(column.name);
    }
    m_Report["cellData"].push_back({ { "file", table.file },
                                     { "columns", columns },
                                     { "rows", table.values.names.size() },
                                     { "unknownLabels", rows.unknownLabels },
                                     { "cellsWithoutRow", rows.cellsWithoutRow } });
    m_Rows.push_back(rows);
  }
}

void
Projection::ProjectTables(ProjectedData & data) const
{
  for (std::size_t i = 0; i < m_Rows.size(); ++i)
  {
    for (const CellTable::Column & column : m_Sources.tables[i].values.columns)
    {
      data.ofCells.push_back(ToCellColumn(column, m_Rows[i].rowOfVertex));
    }
  }
}

void
Projection::ProjectSignal(const ProjectionSources::Signal & signal, const itk::CellWallMesh * mesh,
                          ProjectedData & data)
{
  const auto calculator = itk::CellSignalCalculator<ScalarImage>::New();
  calculator->SetImage(signal.image.image);
  calculator->SetLabelVolume(m_Labels);
  calculator->SetMesh(mesh);
  calculator->SetWallDistance(m_WallDistance);
  calculator->Compute();
  const auto & signals = calculator->GetCellSignals();
  const auto   names = SignalColumnNames(signal.source.name);
  data.ofCells.push_back(ToCellColumn(names[0], signals, &CellSignal::mean));
  data.ofCells.push_back(ToCellColumn(names[1], signals, &CellSignal::integral));
  data.ofCells.push_back(ToCellColumn(names[2], signals, &CellSignal::meanNearWalls));
  data.ofWalls.push_back({ names[0], calculator->GetWallMeans() });

  const Coverage coverage = FindCoverage(signals, mesh->GetJunctionSet().cells);
  const auto     warn = [&](const std::vector<Label> & labels, const std::string & what) {
    if (!labels.empty())
    {
      m_Warnings.push_back(signal.source.file + ": " + CountCells(labels.size()) + " " + what + " (labels " +
                           ListLabels(labels) + ")");
    }
  };
  warn(coverage.without, "have no voxel in it, and no values");
  warn(coverage.partly, "are partly outside of it, or have voxels that are not finite: values are of the rest");
  m_Report["signals"].push_back({ { "file", signal.source.file },
                                  { "name", signal.source.name },
                                  { "wallDistance", calculator->GetUsedWallDistance() },
                                  { "cellsOutside", coverage.without },
                                  { "cellsPartlyOutside", coverage.partly } });
}

ProjectedData
Projection::Project(const itk::CellWallMesh * mesh, ProgressBar & progress)
{
  ProjectedData data;
  this->ProjectTables(data);
  if (!m_Sources.signals.empty())
  {
    progress.Begin("Projecting signals");
  }
  for (ProjectionSources::Signal & signal : m_Sources.signals)
  {
    WithFileName(signal.source.file, [&] { this->ProjectSignal(signal, mesh, data); });
    signal.image.image = nullptr;
  }
  return data;
}
} // namespace tissue
