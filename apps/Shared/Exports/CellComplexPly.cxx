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
WriteCellComplexPly(const WallMesh & mesh, const std::vector<Cell> & cells, const std::string & path)
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
       << "\nproperty list int int vertex_index\nproperty int wall\nelement edge " << facesOfEdge.size()
       << "\nproperty int source\nproperty int target\nproperty list int int face_index\nelement volume "
       << cells.size() - 1 << "\nproperty list int int face_index\nproperty int label\nend_header\n";
  for (const Point & point : mesh.points)
  {
    file << point << '\n';
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & [a, b, c] = mesh.triangles[t];
    file << "3 " << a << ' ' << b << ' ' << c << ' ' << mesh.wallOfTriangle[t] << '\n';
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
    file << ' ' << ToPlyLabel(cells[v].label) << '\n';
  }
  file.Close();
}
} // namespace tissue
