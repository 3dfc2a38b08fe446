/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Optimization/ComplexStatistics.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Complex/AdjacencyComplex.h"
#include "Geometry/ExactPredicates.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
struct Shape
{
  double eccentricity;
  double minimalAngle;
  double maximalAngle;
};

/** Measures the tetrahedron of four points. The dihedral angle between two of its triangles is what the angle between
 * their outward normals leaves of 180 degrees. */
Shape
MeasureShape(const std::array<Point, 4> & p)
{
  constexpr double     degrees = 180.0 / 3.14159265358979323846;
  std::array<Point, 4> normals; // The outward unit normal of the triangle opposite to each vertex.
  double               area = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const VertexTriple t = TriangleOpposite({ { 0, 1, 2, 3 } }, i);
    normals[i] = Cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    area += 0.5 * Norm(normals[i]);
    normals[i] = Normalized(normals[i]);
  }
  const double volume = Dot(p[1] - p[0], Cross(p[2] - p[0], p[3] - p[0])) / 6.0;
  Shape shape{ area > 0.0 ? 1.0 - 216.0 * std::sqrt(3.0) * volume * volume / (area * area * area) : 1.0, 180.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      const double cosine = std::clamp(-Dot(normals[i], normals[j]), -1.0, 1.0);
      const double angle = std::acos(cosine) * degrees;
      shape.minimalAngle = std::min(shape.minimalAngle, angle);
      shape.maximalAngle = std::max(shape.maximalAngle, angle);
    }
  }
  return shape;
}
} // namespace

ComplexStatistics
ComputeStatistics(const std::vector<VertexQuadruple> & tetrahedra, const AdjacencyTuples & tuples,
                  const std::vector<Point> & centers, const ReferenceAdjacency * reference,
                  const EnergyParameters & parameters)
{
  ComplexStatistics statistics;
  statistics.numberOfTetrahedra = tetrahedra.size();
  statistics.numberOfEdges = tuples.pairs.size();
  if (reference)
  {
    statistics.overlap = ComputeAdjacencyOverlap(tuples, *reference);
  }
  // Shapes are summed over the tetrahedra of cells and made means, and so are the deviations over the cells.
  for (const VertexQuadruple & t : tetrahedra)
  {
    if (t[0] == ExteriorVertex)
    {
      continue;
    }
    const Shape shape = MeasureShape({ { centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]] } });
    ++statistics.numberOfInnerTetrahedra;
    statistics.eccentricity += shape.eccentricity;
    statistics.minimalDihedralAngle += shape.minimalAngle;
    statistics.maximalDihedralAngle += shape.maximalAngle;
    if (Orientation(centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]]) <= 0)
    {
      ++statistics.numberOfInvertedTetrahedra;
    }
  }
  if (statistics.numberOfInnerTetrahedra > 0)
  {
    const auto n = static_cast<double>(statistics.numberOfInnerTetrahedra);
    statistics.eccentricity /= n;
    statistics.minimalDihedralAngle /= n;
    statistics.maximalDihedralAngle /= n;
  }
  std::vector<int> numbersOfNeighbors(centers.size(), 0);
  for (const VertexPair & pair : tuples.pairs)
  {
    ++numbersOfNeighbors[pair[0]];
    ++numbersOfNeighbors[pair[1]];
  }
  for (VertexId v = ExteriorVertex + 1; v < static_cast<VertexId>(centers.size()); ++v)
  {
    const bool   touches = tuples.HasPair(ExteriorVertex, v);
    const double ideal = touches ? parameters.epidermalNeighbors + 1.0 : parameters.innerNeighbors;
    const double deviation = (numbersOfNeighbors[v] - ideal) / ideal;
    statistics.neighborhoodError += deviation * deviation;
    statistics.numberOfEpidermalCells += touches ? 1 : 0;
  }
  statistics.neighborhoodError /= std::max(1.0, static_cast<double>(centers.size() - 1));
  return statistics;
}
} // namespace tissue
