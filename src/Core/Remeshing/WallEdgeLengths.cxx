/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/WallEdgeLengths.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "Mesh/WallMeasures.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace tissue
{
namespace
{

/** What the number of triangles depends on: the area of each wall, and the length of each line. */
struct Measures
{
  std::vector<double>   areas;
  std::vector<WallLine> lines;
  std::vector<double>   lengths;
};

/** Returns the number of triangles that come of some edge lengths. A disk of n outline segments and m points within has
 * 2 m + n - 2 of them, by Euler's formula. */
double
CountTriangles(const Measures & measures, const std::vector<double> & edgeLengths)
{
  std::vector<int> segments(measures.areas.size(), 0);
  for (std::size_t i = 0; i < measures.lines.size(); ++i)
  {
    const int n = NumberOfSegments(measures.lengths[i], EdgeLengthAt(measures.lines[i], edgeLengths));
    for (const WallId wall : measures.lines[i].walls)
    {
      segments[wall] += n;
    }
  }
  double count = 0.0;
  for (std::size_t w = 0; w < segments.size(); ++w)
  {
    count += 2.0 * NumberOfInteriorPoints(measures.areas[w], edgeLengths[w], segments[w]) + segments[w] - 2.0;
  }
  return count;
}
} // namespace

void
RequireEdgeLengths(const WallMesh & mesh, const std::vector<double> & edgeLengths)
{
  if (edgeLengths.size() != mesh.walls.size())
  {
    throw std::invalid_argument(std::to_string(edgeLengths.size()) + " edge lengths for " +
                                std::to_string(mesh.walls.size()) + " walls");
  }
  for (const double length : edgeLengths)
  {
    if (!(length > 0.0))
    {
      throw std::invalid_argument("An edge length of a wall is " + std::to_string(length) + ", must be positive");
    }
  }
}

int
NumberOfSegments(double length, double edgeLength)
{
  return std::max(1, static_cast<int>(std::lround(length / edgeLength)));
}

int
NumberOfInteriorPoints(double area, double edgeLength, int outlineSegments)
{
  // An equilateral triangle has the area sqrt(3) / 4 edgeLength^2, and CountTriangles() tells how many points it takes.
  const double triangles = area * 4.0 / (std::sqrt(3.0) * edgeLength * edgeLength);
  return std::max(0, static_cast<int>(std::lround(0.5 * (triangles + 2.0 - outlineSegments))));
}

double
EdgeLengthAt(const WallLine & line, const std::vector<double> & edgeLengths)
{
  double least = edgeLengths[line.walls.front()];
  for (const WallId wall : line.walls)
  {
    least = std::min(least, edgeLengths[wall]);
  }
  return least;
}

std::vector<double>
ChooseEdgeLengths(const WallMesh & mesh, double numberOfTriangles, const std::vector<double> & factors)
{
  if (!(numberOfTriangles > 0.0) || (!factors.empty() && factors.size() != mesh.walls.size()))
  {
    throw std::invalid_argument("ChooseEdgeLengths: no triangles wanted, or not one factor for each wall");
  }
  Measures measures{ ComputeWallAreas(mesh), CollectWallLines(mesh), {} };
  double   area = 0.0;
  for (std::size_t w = 0; w < measures.areas.size(); ++w)
  {
    const double factor = factors.empty() ? 1.0 : factors[w];
    area += measures.areas[w] / (factor * factor);
  }
  for (const WallLine & line : measures.lines)
  {
    measures.lengths.push_back(LengthOf(line, mesh.points));
  }
  std::vector<double> lengths;
  const auto          scaled = [&](double length) {
    lengths.assign(mesh.walls.size(), length);
    for (std::size_t w = 0; w < factors.size(); ++w)
    {
      lengths[w] *= factors[w];
    }
    return lengths;
  };
  // The common length is found by bisection of its logarithm, within a factor of 10 of what equilateral triangles would
  // need. Thirty steps leave a relative error below 1e-8.
  const double equilateral = std::sqrt(area * 4.0 / (std::sqrt(3.0) * numberOfTriangles));
  double       low = 0.1 * equilateral;
  double       high = 10.0 * equilateral;
  for (int i = 0; i < 30; ++i)
  {
    const double middle = std::sqrt(low * high);
    (CountTriangles(measures, scaled(middle)) > numberOfTriangles ? low : high) = middle;
  }
  return scaled(high);
}

std::vector<double>
EdgeLengthFactorsByCell(const WallMesh & mesh, const std::vector<double> & volumes, double exponent)
{
  std::vector<double> ofCells(volumes.begin() + std::min<std::size_t>(1, volumes.size()), volumes.end());
  if (ofCells.empty())
  {
    return std::vector<double>(mesh.walls.size(), 1.0);
  }
  const double        median = Median(std::move(ofCells));
  std::vector<double> factors;
  factors.reserve(mesh.walls.size());
  for (const WallMesh::Wall & wall : mesh.walls)
  {
    double volume = volumes[wall.cells[0]];
    if (wall.cells[1] != ExteriorVertex)
    {
      volume = std::min(volume, volumes[wall.cells[1]]);
    }
    const double size = median > 0.0 ? std::cbrt(std::max(0.0, volume) / median) : 1.0;
    factors.push_back(std::clamp(std::pow(size, exponent), 1.0 / 3.0, 3.0));
  }
  return factors;
}
} // namespace tissue
