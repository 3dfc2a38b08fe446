/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Projection/ProjectionSources.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Points/PointColumnName.h"
#include "Shared/Projection/CellColumnNames.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
CellTable
ReadTable(const std::string & path, const std::string & labelColumn)
{
  if (std::filesystem::is_directory(path))
  {
    throw std::runtime_error("a folder, not a table");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error("no such file, or it cannot be read");
  }
  return ReadCellTable(stream, labelColumn);
}

/** Adds a name to those that are taken. */
void
TakeName(const std::string & name, const std::string & remedy, std::map<std::string, std::string> & ownerOf,
         const std::string & owner)
{
  const auto known = ownerOf.emplace(name, owner);
  if (!known.second)
  {
    throw std::runtime_error("the column " + QuoteName(name) + " has the name of one of " + known.first->second + ": " +
                             remedy);
  }
}

/** No two columns, on cells or walls, may have one name, nor that of a statistic. */
void
RequireDifferentNames(const ProjectionSources & sources)
{
  std::map<std::string, std::string> ownerOf;
  for (const std::string & name : ReservedColumnNames())
  {
    ownerOf.emplace(name, "the statistics");
  }
  for (const ProjectionSources::Table & table : sources.tables)
  {
    WithFileName(table.file, [&] {
      for (const CellTable::Column & column : table.values.columns)
      {
        TakeName(column.name, "another name, or a table without it, is needed", ownerOf, table.file);
      }
    });
  }
  for (const ProjectionSources::Signal & signal : sources.signals)
  {
    WithFileName(signal.source.file, [&] {
      for (const std::string & name : SignalColumnNames(signal.source.name))
      {
        TakeName(name, "--signal NAME=FILE gives another one", ownerOf, signal.source.file);
      }
    });
  }
}

/** The vertices of the cells by the texts that a table may have for them. */
std::map<std::string, std::size_t>
VerticesByName(const std::vector<Cell> & cells, const std::map<Label, std::string> & names)
{
  std::map<std::string, std::size_t> vertexOf;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    const auto name = names.find(cells[v].label);
    if (name != names.end())
    {
      vertexOf.emplace(name->second, v);
    }
  }
  return vertexOf;
}
} // namespace

std::vector<std::string>
ProjectionSources::ColumnNames() const
{
  std::vector<std::string> names;
  for (const Table & table : tables)
  {
    for (const CellTable::Column & column : table.values.columns)
    {
      names.push_back(column.name);
    }
  }
  for (const Signal & signal : signals)
  {
    const auto ofSignal = SignalColumnNames(signal.source.name);
    names.insert(names.end(), ofSignal.begin(), ofSignal.end());
  }
  return names;
}

std::vector<std::string>
ProjectionSources::Warnings() const
{
  std::vector<std::string> warnings;
  const auto               add = [&warnings](const std::string & file, const std::vector<std::string> & ofFile) {
    for (const std::string & warning : ofFile)
    {
      warnings.push_back(file + ": " + warning);
    }
  };
  for (const Table & table : tables)
  {
    add(table.file, table.values.warnings);
  }
  for (const Signal & signal : signals)
  {
    add(signal.source.file, signal.image.warnings);
  }
  return warnings;
}

std::vector<std::string>
SignalColumnNames(const std::string & signal)
{
  return { signal + "Mean", signal + "Integral", signal + "NearWalls" };
}

ProjectionSources
ReadProjectionSources(const ProjectionOptions & options, ProgressBar & progress)
{
  ProjectionSources sources;
  const auto        signals = ListSignals(options);
  if (!options.tables.empty() || !signals.empty())
  {
    progress.Begin("Reading what is projected");
  }
  for (const std::string & file : options.tables)
  {
    sources.tables.push_back({ file, WithFileName(file, [&] { return ReadTable(file, options.labelColumn); }) });
  }
  for (const SignalSource & signal : signals)
  {
    sources.signals.push_back({ signal, ReadScalarImage(signal.file, signal.image) });
  }
  RequireDifferentNames(sources);
  return sources;
}

MatchedRows
MatchRows(const CellTable & table, const std::vector<Cell> & cells, const std::map<Label, std::string> & names)
{
  const auto                   vertexOfName = VerticesByName(cells, names);
  std::map<Label, std::size_t> vertexOfLabel;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    vertexOfLabel.emplace(cells[v].label, v);
  }
  MatchedRows matched;
  matched.rowOfVertex.assign(cells.size(), -1);
  const bool isByName = std::any_of(
    table.names.begin(), table.names.end(), [&](const auto & name) { return vertexOfName.count(name) > 0; });
  if (!isByName && table.labels.empty())
  {
    throw std::runtime_error("the labels are names (" + QuoteName(table.names.front()) + ", ...), " +
                             (names.empty()
                                ? "those of the tissue are numbers"
                                : "of which the tissue has none: its first is " + QuoteName(names.begin()->second)));
  }
  std::size_t numberOfMatches = 0;
  for (std::size_t row = 0; row < table.names.size(); ++row)
  {
    const auto byName = vertexOfName.find(table.names[row]);
    const auto byLabel = isByName ? vertexOfLabel.end() : vertexOfLabel.find(table.labels[row]);
    if (isByName ? byName == vertexOfName.end() : byLabel == vertexOfLabel.end())
    {
      matched.unknownLabels.push_back(table.names[row]);
      continue;
    }
    matched.rowOfVertex[isByName ? byName->second : byLabel->second] = static_cast<std::ptrdiff_t>(row);
    ++numberOfMatches;
  }
  if (numberOfMatches == 0)
  {
    throw std::runtime_error("no row has the label of a cell: the first is " + QuoteName(table.names.front()) +
                             ", the cells' are " + std::to_string(vertexOfLabel.begin()->first) + " to " +
                             std::to_string(vertexOfLabel.rbegin()->first));
  }
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    if (matched.rowOfVertex[v] < 0)
    {
      matched.cellsWithoutRow.push_back(cells[v].label);
    }
  }
  return matched;
}

void
RequireOverlap(const ScalarImage * image, const LabelVolume & labels, std::size_t numberOfVertices)
{
  std::size_t i = 0;
  for (std::int32_t z = 0; z < labels.size[2]; ++z)
  {
    for (std::int32_t y = 0; y < labels.size[1]; ++y)
    {
      for (std::int32_t x = 0; x < labels.size[0]; ++x)
      {
        const auto vertex = static_cast<std::size_t>(labels.vertices[i++]);
        if (vertex == ExteriorVertex || vertex >= numberOfVertices)
        {
          continue;
        }
        const Point position =
          labels.ToPhysical({ { static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) } });
        const ScalarImage::PointType point(position.data());
        if (image->GetLargestPossibleRegion().IsInside(image->TransformPhysicalPointToContinuousIndex<double>(point)))
        {
          return;
        }
      }
    }
  }
  const auto         size = image->GetLargestPossibleRegion().GetSize();
  std::ostringstream text;
  text << "the image lies beside the tissue: no voxel of a cell is in it. It begins at " << image->GetOrigin()
       << " and has " << size[0] << " x " << size[1] << " x " << size[2] << " voxels of " << image->GetSpacing()[0]
       << " x " << image->GetSpacing()[1] << " x " << image->GetSpacing()[2] << "; the labels begin at "
       << ScalarImage::PointType(labels.origin.data()) << " and have " << labels.size[0] << " x " << labels.size[1]
       << " x " << labels.size[2] << " voxels of " << Norm(labels.steps[0]) << " x " << Norm(labels.steps[1]) << " x "
       << Norm(labels.steps[2]);
  throw std::runtime_error(text.str());
}
} // namespace tissue
