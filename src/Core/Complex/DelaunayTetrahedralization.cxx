/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/DelaunayTetrahedralization.h"

#include "Complex/AdjacencyComplex.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<VertexId, Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

void
RefuseRepeatedPoints(const std::vector<Point> & centers)
{
  std::vector<VertexId> order;
  for (std::size_t v = 1; v < centers.size(); ++v)
  {
    order.push_back(static_cast<VertexId>(v));
  }
  std::stable_sort(order.begin(), order.end(), [&](VertexId a, VertexId b) { return centers[a] < centers[b]; });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (centers[order[i - 1]] == centers[order[i]])
    {
      throw std::invalid_argument("DelaunayTetrahedralization: the cells of vertices " + std::to_string(order[i - 1]) +
                                  " and " + std::to_string(order[i]) + " have the same centre");
    }
  }
}
} // namespace

std::vector<VertexQuadruple>
DelaunayTetrahedralization(const std::vector<Point> & centers)
{
  if (centers.size() < 5)
  {
    throw std::invalid_argument(
      "DelaunayTetrahedralization: " + std::to_string(std::max<std::size_t>(centers.size(), 1) - 1) +
      " cells, at least 4 are needed");
  }
  RefuseRepeatedPoints(centers);
  std::vector<std::pair<Kernel::Point_3, VertexId>> points;
  for (std::size_t v = 1; v < centers.size(); ++v)
  {
    points.emplace_back(Kernel::Point_3(centers[v][0], centers[v][1], centers[v][2]), static_cast<VertexId>(v));
  }
  Delaunay delaunay(points.begin(), points.end());
  if (delaunay.dimension() < 3)
  {
    throw std::invalid_argument("DelaunayTetrahedralization: all " + std::to_string(points.size()) +
                                " cell centres are coplanar");
  }
  // CGAL's infinite vertex is the exterior: its cells are the tetrahedra to the exterior, already oriented.
  delaunay.infinite_vertex()->info() = ExteriorVertex;
  std::vector<VertexQuadruple> tetrahedra;
  for (auto cell = delaunay.all_cells_begin(); cell != delaunay.all_cells_end(); ++cell)
  {
    tetrahedra.push_back(Canonical(
      { { cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info() } }));
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}
} // namespace tissue
