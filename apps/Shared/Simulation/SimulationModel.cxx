/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Simulation/SimulationModel.h"

#include "Shared/Files/NumberFile.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
constexpr Label largestTag = std::numeric_limits<std::int32_t>::max();

/** Numbers from 1 on, as {1, 2}. */
template <typename TNumbers>
std::string
InBraces(const TNumbers & numbers)
{
  std::string text;
  for (const auto number : numbers)
  {
    text += (text.empty() ? "{" : ", ") + std::to_string(number);
  }
  return text + "}";
}

/** A tag of each cell: its label, or where that is none a number that no label is. */
std::map<Label, std::int64_t>
ChooseTags(const std::vector<Cell> & cells)
{
  std::set<std::int64_t>        taken;
  std::map<Label, std::int64_t> tags;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    taken.insert(cells[v].label);
  }
  std::int64_t next = 1;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    const Label label = cells[v].label;
    while (taken.count(next) > 0)
    {
      ++next;
    }
    tags[label] = label >= 1 && label <= largestTag ? label : next++;
  }
  return tags;
}
} // namespace

SimulationModel::SimulationModel(const WallMesh & mesh, const std::vector<Cell> & cells)
  : m_Mesh(mesh)
  , m_Cells(cells)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  m_Solids = FindCellSolids(mesh, cells.size());
}

Label
SimulationModel::LabelOf(VertexId vertex) const
{
  return m_Cells[static_cast<std::size_t>(vertex)].label;
}

void
SimulationModel::WriteGmshWalls(const std::string & path) const
{
  NumberFile file(path);
  file << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << m_Mesh.points.size() << '\n';
  for (std::size_t p = 0; p < m_Mesh.points.size(); ++p)
  {
    file << p + 1 << ' ' << m_Mesh.points[p] << '\n';
  }
  file << "$EndNodes\n$Elements\n" << m_Mesh.triangles.size() << '\n';
  for (std::size_t t = 0; t < m_Mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = m_Mesh.triangles[t];
    file << t + 1 << " 2 2 0 " << m_Mesh.wallOfTriangle[t] + 1 << ' ' << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  file << "$EndElements\n";
  file.Close();
}

void
SimulationModel::WriteGmshModel(const std::string & path, const std::string & walls) const
{
  NumberFile file(path);
  file << "// The cells of a tissue by their walls. gmsh -3 meshes them.\nMerge \"" << walls << "\";\n";
  std::map<VertexId, std::vector<std::size_t>> volumesOfCell;
  std::size_t                                  loop = 0;
  std::size_t                                  volume = 0;
  for (const CellSolid & solid : m_Solids.solids)
  {
    if (solid.cell == ExteriorVertex)
    {
      continue;
    }
    std::vector<std::size_t> loops;
    for (std::vector<WallId> surface : solid.surfaces)
    {
      std::for_each(surface.begin(), surface.end(), [](WallId & wall) { ++wall; });
      loops.push_back(++loop);
      file << "Surface Loop(" << loop << ") = " << InBraces(surface) << ";\n";
    }
    file << "Volume(" << ++volume << ") = " << InBraces(loops) << ";\n";
    volumesOfCell[solid.cell].push_back(volume);
  }
  const std::map<Label, std::int64_t> tags = ChooseTags(m_Cells);
  for (const auto & [cell, volumes] : volumesOfCell)
  {
    const Label label = this->LabelOf(cell);
    file << "Physical Volume(\"cell_" << label << "\", " << tags.at(label) << ") = " << InBraces(volumes) << ";\n";
  }
  std::map<VertexPair, std::vector<std::size_t>> wallsOfPair;
  const std::set<WallId>                         used(m_Mesh.wallOfTriangle.begin(), m_Mesh.wallOfTriangle.end());
  for (const WallId wall : used)
  {
    wallsOfPair[m_Mesh.walls[static_cast<std::size_t>(wall)].cells].push_back(static_cast<std::size_t>(wall) + 1);
  }
  for (const auto & [pair, ofPair] : wallsOfPair)
  {
    file << "Physical Surface(\"wall_" << this->LabelOf(pair[0]) << '_' << this->LabelOf(pair[1]) << "\", "
         << ofPair.front() << ") = " << InBraces(ofPair) << ";\n";
  }
  for (const VertexId cell : m_Solids.openCells)
  {
    file << "// Cell " << this->LabelOf(cell) << " has no volume, as its surface is not closed.\n";
  }
  file.Close();
}

void
SimulationModel::WriteTetGenModel(const std::string & path) const
{
  NumberFile file(path);
  file << "# The cells of a tissue by their walls. tetgen -pqAY meshes them.\n" << m_Mesh.points.size() << " 3 0 0\n";
  for (std::size_t p = 0; p < m_Mesh.points.size(); ++p)
  {
    file << p << ' ' << m_Mesh.points[p] << '\n';
  }
  file << m_Mesh.triangles.size() << " 1\n";
  for (std::size_t t = 0; t < m_Mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = m_Mesh.triangles[t];
    file << "3 " << a << ' ' << b << ' ' << c << ' ' << m_Mesh.wallOfTriangle[t] + 1 << '\n';
  }
  const auto & solids = m_Solids.solids;
  const auto   isVoid = [](const CellSolid & solid) { return solid.cell == ExteriorVertex; };
  const auto   numberOfVoids = std::count_if(solids.begin(), solids.end(), isVoid);
  file << numberOfVoids << '\n';
  std::size_t number = 0;
  for (const CellSolid & solid : solids)
  {
    if (isVoid(solid))
    {
      file << number++ << ' ' << solid.inside << '\n';
    }
  }
  file << solids.size() - static_cast<std::size_t>(numberOfVoids) << '\n';
  number = 0;
  for (const CellSolid & solid : solids)
  {
    if (!isVoid(solid))
    {
      file << number++ << ' ' << solid.inside << ' ' << this->LabelOf(solid.cell) << '\n';
    }
  }
  for (const VertexId cell : m_Solids.openCells)
  {
    file << "# Cell " << this->LabelOf(cell) << " has no region, as its surface is not closed.\n";
  }
  file.Close();
}

bool
IsGmshModel(const std::string & model)
{
  return std::filesystem::path(model).extension() == ".geo";
}

std::string
GmshWallsBeside(const std::string & model)
{
  return std::filesystem::path(model).replace_extension(".msh").string();
}
} // namespace tissue
