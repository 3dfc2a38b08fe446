/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKProjectedData_h
#define TissueTessellationVTKProjectedData_h

#include "TissueTessellationVTK/Arrays.h"

#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tissue
{
/** Values of the cells, by vertex: numbers, which are not a number where none is known, or else texts. */
struct CellColumn
{
  std::string              name;
  std::vector<double>      numbers;
  std::vector<std::string> texts;
};

/** Numbers of the walls, in the order of the mesh. */
struct WallColumn
{
  std::string         name;
  std::vector<double> numbers;
};

/** What of other origin is known of cells and walls, to be added to their statistics. */
struct ProjectedData
{
  std::vector<CellColumn> ofCells;
  std::vector<WallColumn> ofWalls;
};

namespace bridge
{
/** The vertices of the cells, by their labels in an array of the attributes; the exterior's for others. */
inline std::vector<VertexId>
FindVertices(vtkFieldData * attributes, const char * labelArray, const std::vector<Cell> & cells)
{
  std::map<Label, VertexId> vertexOf;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    vertexOf[cells[v].label] = static_cast<VertexId>(v);
  }
  const auto * const    labels = vtkTypeInt64Array::SafeDownCast(attributes->GetArray(labelArray));
  std::vector<VertexId> vertices;
  for (vtkIdType i = 0; labels != nullptr && i < labels->GetNumberOfTuples(); ++i)
  {
    const auto found = vertexOf.find(labels->GetValue(i));
    vertices.push_back(found == vertexOf.end() ? ExteriorVertex : found->second);
  }
  return vertices;
}

/** Adds a column with the values of the given vertices. */
inline void
AddCellColumn(vtkFieldData * attributes, const std::string & name, const CellColumn & column,
              const std::vector<VertexId> & vertices)
{
  if (column.texts.empty())
  {
    AddColumn<vtkTypeFloat64Array>(
      attributes, name.c_str(), vertices, [&column](VertexId v) { return column.numbers.at(v); });
    return;
  }
  const vtkNew<vtkStringArray> texts;
  texts->SetName(name.c_str());
  for (const VertexId v : vertices)
  {
    texts->InsertNextValue(column.texts.at(v));
  }
  attributes->AddArray(texts);
}
} // namespace bridge

/** Whether columns of text are added. */
enum class TextColumns
{
  Added,
  LeftOut
};

/** Adds columns of the cells to what has an array `Label` of such: MakeCellTable, MakeCellGrid, MakeCellSurfaces.
 * \throws std::out_of_range where a column is for fewer vertices. */
inline void
AddCellColumns(vtkFieldData * attributes, const std::vector<Cell> & cells, const ProjectedData & data,
               TextColumns texts = TextColumns::Added)
{
  const std::vector<VertexId> vertices = bridge::FindVertices(attributes, "Label", cells);
  for (const CellColumn & column : data.ofCells)
  {
    if (texts == TextColumns::Added || column.texts.empty())
    {
      bridge::AddCellColumn(attributes, column.name, column, vertices);
    }
  }
}

/** \brief Adds columns of the walls, and those of the cells on both sides, with 0 and 1 behind their names, to what has
 * arrays `WallId`, `Label0` and `Label1`: MakeWallPolyData, MakeWallTable.
 *
 * The values of the exterior are those that the columns have for it.
 * \throws std::out_of_range where a column is for fewer walls or vertices. */
inline void
AddWallColumns(vtkFieldData * attributes, const std::vector<Cell> & cells, const ProjectedData & data)
{
  vtkDataArray * const walls = attributes->GetArray("WallId");
  std::vector<WallId>  ids;
  for (vtkIdType i = 0; walls != nullptr && i < walls->GetNumberOfTuples(); ++i)
  {
    ids.push_back(static_cast<WallId>(walls->GetTuple1(i)));
  }
  for (const WallColumn & column : data.ofWalls)
  {
    bridge::AddColumn<vtkTypeFloat64Array>(
      attributes, column.name.c_str(), ids, [&column](WallId w) { return column.numbers.at(w); });
  }
  const std::vector<VertexId> vertices[] = { bridge::FindVertices(attributes, "Label0", cells),
                                             bridge::FindVertices(attributes, "Label1", cells) };
  for (const CellColumn & column : data.ofCells)
  {
    bridge::AddCellColumn(attributes, column.name + "0", column, vertices[0]);
    bridge::AddCellColumn(attributes, column.name + "1", column, vertices[1]);
  }
}

/** Adds columns of the walls to MakeNeighborTable: the mean over all walls of two cells, by their areas; of the walls
 * where it is known. \param statistics of the walls of the mesh. */
inline void
AddNeighborColumns(vtkFieldData * attributes, const WallMesh & mesh, const std::vector<Cell> & cells,
                   const std::vector<WallStatistics> & statistics, const ProjectedData & data)
{
  const std::vector<VertexId> first = bridge::FindVertices(attributes, "Label0", cells);
  const std::vector<VertexId> second = bridge::FindVertices(attributes, "Label1", cells);
  std::vector<VertexPair>     pairs;
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    pairs.push_back({ { std::min(first[i], second[i]), std::max(first[i], second[i]) } });
  }
  for (const WallColumn & column : data.ofWalls)
  {
    struct Sum
    {
      double weighted = 0.0;
      double area = 0.0;
    };
    std::map<VertexPair, Sum> sums;
    for (std::size_t w = 0; w < mesh.walls.size(); ++w)
    {
      VertexPair sides = mesh.walls[w].cells;
      std::sort(sides.begin(), sides.end());
      if (std::isfinite(column.numbers.at(w)))
      {
        sums[sides].weighted += statistics[w].area * column.numbers[w];
        sums[sides].area += statistics[w].area;
      }
    }
    bridge::AddColumn<vtkTypeFloat64Array>(attributes, column.name.c_str(), pairs, [&sums](const VertexPair & pair) {
      const auto found = sums.find(pair);
      const bool isKnown = found != sums.end() && found->second.area > 0.0;
      return isKnown ? found->second.weighted / found->second.area : UnknownStatistic;
    });
  }
}
} // namespace tissue

#endif
