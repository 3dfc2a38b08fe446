/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Exports/CellComplexPly.h"

#include "Shared/Files/NumberFile.h"

#include <algorithm>
#include <map>

namespace tissue
{
namespace
{
void
WriteList(NumberFile & file, const std::vector<std::size_t> & numbers)
{
  file << numbers.size();
  for (const std::size_t number : numbers)
  {
    file << ' ' << number;
  }
}

std::string
ToPropertyName(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  return name;
}

/** The properties of columns of numbers. */
template <typename TColumn>
void
DeclareColumns(NumberFile & file, const std::vector<TColumn> & columns)
{
  for (const TColumn & column : columns)
  {
    if (!column.numbers.empty())
    {
      file << "\nproperty float " << ToPropertyName(column.name);
    }
  }
}

template <typename TColumn>
void
WriteColumns(NumberFile & file, const std::vector<TColumn> & columns, std::size_t i)
{
  for (const TColumn & column : columns)
  {
    if (!column.numbers.empty())
    {
      file << ' ' << column.numbers.at(i);
    }
  }
}
} // namespace

std::int32_t
ToPlyLabel(Label label)
{
  if (label < std::numeric_limits<std::int32_t>::min() || label > std::numeric_limits<std::int32_t>::max())
  {
    throw std::runtime_error("a PLY has labels of 32 bits, " + std::to_string(label) + " has more");
  }
  return static_cast<std::int32_t>(label);
}

void
WriteCellComplexPly(const WallMesh & mesh, const std::vector<Cell> & cells, const ProjectedData & data,
                    const std::string & path)
{
  std::map<std::pair<PointId, PointId>, std::vector<std::size_t>> facesOfEdge;
  std::vector<std::vector<std::size_t>>                           facesOfCell(cells.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle & triangle = mesh.triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      facesOfEdge[std::minmax(triangle[i], triangle[(i + 1) % 3])].push_back(t);
    }
    for (const VertexId cell : mesh.walls[static_cast<std::size_t>(mesh.wallOfTriangle[t])].cells)
    {
      facesOfCell[static_cast<std::size_t>(cell)].push_back(t);
    }
  }
  NumberFile file(path);
  file << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
       << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.triangles.size()
       << "\nproperty list int int vertex_index\nproperty int wall";
  DeclareColumns(file, data.ofWalls);
  file << "\nelement edge " << facesOfEdge.size()
       << "\nproperty int source\nproperty int target\nproperty list int int face_index\nelement volume "
       << cells.size() - 1 << "\nproperty list int int face_index\nproperty int label";
  DeclareColumns(file, data.ofCells);
  file << "\nend_header\n";
  for (const Point & point : mesh.points)
  {
    file << point << '\n';
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    file << "3 " << a << ' ' << b << ' ' << c << ' ' << mesh.wallOfTriangle[t];
    WriteColumns(file, data.ofWalls, static_cast<std::size_t>(mesh.wallOfTriangle[t]));
    file << '\n';
  }
  for (const auto & [edge, faces] : facesOfEdge)
  {
    file << edge.first << ' ' << edge.second << ' ';
    WriteList(file, faces);
    file << '\n';
  }
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    WriteList(file, facesOfCell[v]);
    file << ' ' << ToPlyLabel(cells[v].label);
    WriteColumns(file, data.ofCells, v);
    file << '\n';
  }
  file.Close();
}
} // namespace tissue
