/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Exports/ExportedCells.h"

#include "TissueTessellationVTK/CellSurfaces.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
/** The cells of the labels, by their vertices; all of them where there are none. */
std::vector<VertexId>
FindVertices(const std::vector<Cell> & cells, const std::vector<Label> & labels)
{
  std::map<Label, VertexId> vertexOf;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    vertexOf[cells[v].label] = static_cast<VertexId>(v);
  }
  std::set<VertexId> vertices;
  for (const Label label : labels)
  {
    const auto found = vertexOf.find(label);
    if (found == vertexOf.end())
    {
      throw std::runtime_error("--exportCells: there is no cell of label " + std::to_string(label));
    }
    vertices.insert(found->second);
  }
  for (const auto & [label, vertex] : vertexOf)
  {
    if (labels.empty())
    {
      vertices.insert(vertex);
    }
  }
  return { vertices.begin(), vertices.end() };
}
} // namespace

std::vector<ExportedCell>
CollectExportedCells(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels)
{
  std::vector<OwnSurface>   surfaces = CollectOwnSurfaces(mesh, cells.size());
  const std::vector<Color>  colors = ChooseCellColors(mesh, static_cast<VertexId>(cells.size()));
  std::vector<ExportedCell> exported;
  for (const VertexId vertex : FindVertices(cells, labels))
  {
    const auto   v = static_cast<std::size_t>(vertex);
    ExportedCell cell{ cells[v].label, colors[v], {}, std::move(surfaces[v].triangles) };
    for (const PointId p : surfaces[v].points)
    {
      cell.points.push_back(mesh.points[static_cast<std::size_t>(p)]);
    }
    if (!cell.triangles.empty())
    {
      exported.push_back(std::move(cell));
    }
  }
  return exported;
}
} // namespace tissue
