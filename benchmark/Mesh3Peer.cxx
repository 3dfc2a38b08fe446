/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The headers of Mesh_3 are GPL-3.0-or-later or commercial: so is the program this becomes part of.
#include "PeerMeshers.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <map>

namespace tissue
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

CGAL::Image_3
MakeCGALImage(const CellImage * image)
{
  const auto size = image->GetBufferedRegion().GetSize();
  const auto spacing = image->GetSpacing();
  static_assert(sizeof(VertexId) == 4, "An image of words of four bytes.");
  _image * copy =
    _createImage(size[0], size[1], size[2], 1, spacing[0], spacing[1], spacing[2], 4, WK_FIXED, SGN_SIGNED);
  std::copy_n(
    image->GetBufferPointer(), image->GetBufferedRegion().GetNumberOfPixels(), static_cast<VertexId *>(copy->data));
  return CGAL::Image_3(copy);
}

/** Gives the cell that a tetrahedron is part of. */
VertexId
SubdomainOf(const Complex & complex, const Triangulation::Cell_handle & cell)
{
  return complex.is_in_complex(cell) ? static_cast<VertexId>(complex.subdomain_index(cell)) : ExteriorVertex;
}

LabelledTriangles::Triangle
MakeTriangle(const Complex & complex, const Triangulation::Facet & facet,
             const std::map<Triangulation::Vertex_handle, PointId> & ids)
{
  const auto & [cell, opposite] = facet;
  LabelledTriangles::Triangle triangle;
  // The normal points into the facet's tetrahedron.
  for (int k = 0; k < 3; ++k)
  {
    triangle.points[k] = ids.at(cell->vertex(Triangulation::vertex_triple_index(opposite, k)));
  }
  triangle.cells = { { SubdomainOf(complex, cell->neighbor(opposite)), SubdomainOf(complex, cell) } };
  return triangle;
}

LabelledTriangles
ExtractBoundaries(const Complex & complex)
{
  const Triangulation &                           triangulation = complex.triangulation();
  LabelledTriangles                               mesh;
  std::map<Triangulation::Vertex_handle, PointId> ids;
  for (auto vertex : triangulation.finite_vertex_handles())
  {
    ids.emplace(vertex, static_cast<PointId>(mesh.points.size()));
    const auto & p = vertex->point();
    mesh.points.push_back({ { CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) } });
  }
  for (const auto & facet : triangulation.finite_facets())
  {
    if (SubdomainOf(complex, facet.first) != SubdomainOf(complex, facet.first->neighbor(facet.second)))
    {
      mesh.triangles.push_back(MakeTriangle(complex, facet, ids));
    }
  }
  return mesh;
}
} // namespace

PeerMesh
MeshByMesh3(const CellImage * image, const Mesh3Parameters & parameters)
{
  namespace named = CGAL::parameters;
  const CGAL::Image_3 labels = MakeCGALImage(image);
  Stopwatch           stopwatch;
  // With a random generator of its own the mesh is the same each time.
  CGAL::Random   random(0);
  const Domain   domain = Domain::create_labeled_image_mesh_domain(labels, named::p_rng = &random);
  constexpr int  facetAngle = 30;         // In degrees: with at most this the refinement is sure to end.
  constexpr int  cellRadiusEdgeRatio = 3; // With more than 2 the refinement is sure to end.
  const Criteria criteria(named::facet_angle = facetAngle,
                          named::facet_size = parameters.facetSize,
                          named::facet_distance = parameters.facetDistance * parameters.facetSize,
                          named::cell_radius_edge_ratio = cellRadiusEdgeRatio,
                          named::cell_size = parameters.cellSize * parameters.facetSize);
  const Complex  complex = CGAL::make_mesh_3<Complex>(domain, criteria, named::no_perturb(), named::no_exude());
  PeerMesh       result;
  result.time = stopwatch.Lap();
  result.boundaries = ExtractBoundaries(complex);
  result.numberOfOutputTriangles = result.boundaries.triangles.size();
  return result;
}
} // namespace tissue
