/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/SolidMoments.h"

#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
namespace
{
/** Adds the tetrahedron of an outward triangle and the origin; the centroid and the covariance are sums until then. */
void
AddTetrahedron(const std::array<Point, 3> & corners, double sign, SolidMoments & solid)
{
  const double volume = sign * Dot(corners[0], Cross(corners[1], corners[2])) / 6.0;
  const Point  sum = corners[0] + corners[1] + corners[2];
  solid.area += TriangleArea(corners[0], corners[1], corners[2]);
  solid.volume += volume;
  solid.centroid = solid.centroid + 0.25 * volume * sum;
  AddOuterProduct(volume / 20.0, sum, solid.covariance);
  for (const Point & corner : corners)
  {
    AddOuterProduct(volume / 20.0, corner, solid.covariance);
  }
}
} // namespace

std::vector<SolidMoments>
MeasureSolids(const WallMesh & mesh, std::size_t numberOfVertices)
{
  // Each cell is measured from a point of its own: from the origin its moments would be differences of large numbers.
  std::vector<SolidMoments> solids(numberOfVertices);
  std::vector<PointId>      origins(numberOfVertices, -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle &   triangle = mesh.triangles[t];
    const VertexPair & sides = mesh.walls[mesh.wallOfTriangle[t]].cells;
    for (int side = 0; side < 2; ++side)
    {
      const VertexId cell = sides[side];
      origins[cell] = origins[cell] < 0 ? triangle[0] : origins[cell];
      const Point & origin = mesh.points[origins[cell]];
      AddTetrahedron(
        { { mesh.points[triangle[0]] - origin, mesh.points[triangle[1]] - origin, mesh.points[triangle[2]] - origin } },
        side == 0 ? 1.0 : -1.0,
        solids[cell]);
    }
  }
  for (std::size_t cell = 0; cell < numberOfVertices; ++cell)
  {
    SolidMoments & solid = solids[cell];
    if (cell == ExteriorVertex || !(solid.volume > 0.0))
    {
      solid = cell == ExteriorVertex ? SolidMoments() : SolidMoments{ solid.area, solid.volume };
      continue;
    }
    solid.centroid = (1.0 / solid.volume) * solid.centroid;
    for (double & entry : solid.covariance)
    {
      entry /= solid.volume;
    }
    AddOuterProduct(-1.0, solid.centroid, solid.covariance);
    solid.centroid = solid.centroid + mesh.points[origins[cell]];
  }
  return solids;
}
} // namespace tissue
