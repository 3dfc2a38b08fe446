/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/VolumeFitting.h"

#include "TissueTessellationCore/Vector.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
constexpr int    MaximumIterations = 100;
constexpr double Tolerance = 1e-6;
constexpr double Damping = 1e-3;

/** How a cell's volume changes with a point. */
struct VolumeGradient
{
  PointId  point;
  VertexId cell;
  Point    gradient;
};

std::vector<VolumeGradient>
CollectGradients(const WallMesh & mesh)
{
  std::vector<VolumeGradient>              all;
  std::vector<std::vector<VolumeGradient>> atPoint(mesh.points.size());
  const auto                               add = [&atPoint](PointId p, VertexId cell, const Point & g) {
    if (cell == ExteriorVertex)
    {
      return;
    }
    for (VolumeGradient & entry : atPoint[p])
    {
      if (entry.cell == cell)
      {
        entry.gradient = entry.gradient + g;
        return;
      }
    }
    atPoint[p].push_back({ p, cell, g });
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto &       triangle = mesh.triangles[t];
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    for (int i = 0; i < 3; ++i)
    {
      const Point & p = mesh.points[triangle[i]];
      const Point   g =
        (1.0 / 6.0) * Cross(mesh.points[triangle[(i + 1) % 3]] - p, mesh.points[triangle[(i + 2) % 3]] - p);
      // A third of the triangle's area: what is left of the cone's derivative once the surface is closed.
      add(triangle[i], cells[0], g);
      add(triangle[i], cells[1], -1.0 * g);
    }
  }
  for (const auto & entries : atPoint)
  {
    all.insert(all.end(), entries.begin(), entries.end());
  }
  return all;
}

double
Product(const std::vector<double> & a, const std::vector<double> & b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/** The displacement of each point under the pressures. */
void
Displace(const std::vector<VolumeGradient> & gradients, const std::vector<double> & pressures,
         std::vector<Point> & displacements)
{
  std::fill(displacements.begin(), displacements.end(), Point{ { 0.0, 0.0, 0.0 } });
  for (const VolumeGradient & g : gradients)
  {
    displacements[g.point] = displacements[g.point] + pressures[g.cell] * g.gradient;
  }
}
} // namespace

std::vector<double>
ComputeVolumes(const WallMesh & mesh, std::size_t numberOfVertices)
{
  std::vector<double> volumes(numberOfVertices, 0.0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & triangle = mesh.triangles[t];
    const auto & origin = mesh.points.front();
    const double volume = Dot(mesh.points[triangle[0]] - origin,
                              Cross(mesh.points[triangle[1]] - origin, mesh.points[triangle[2]] - origin)) /
                          6.0;
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    volumes[cells[0]] += volume;
    volumes[cells[1]] -= volume;
  }
  volumes[ExteriorVertex] = 0.0;
  return volumes;
}

void
FitVolumes(WallMesh & mesh, const std::vector<double> & volumes, double largestShare)
{
  const std::vector<VolumeGradient> gradients = CollectGradients(mesh);
  const std::vector<double>         current = ComputeVolumes(mesh, volumes.size());
  const std::size_t                 n = volumes.size();
  std::vector<double>               residual(n, 0.0);
  for (std::size_t c = ExteriorVertex + 1; c < n; ++c)
  {
    const double cap = largestShare * volumes[c];
    residual[c] = volumes[c] > 0.0 ? std::clamp(volumes[c] - current[c], -cap, cap) : 0.0;
  }
  std::vector<double> diagonal(n, 0.0);
  for (const VolumeGradient & g : gradients)
  {
    diagonal[g.cell] += Dot(g.gradient, g.gradient);
  }
  for (double & d : diagonal)
  {
    d = d > 0.0 ? d : 1.0;
  }
  std::vector<Point>  displacements(mesh.points.size());
  std::vector<double> pressures(n, 0.0);
  std::vector<double> product(n);
  std::vector<double> scaled(n);
  const auto          precondition = [&]() {
    for (std::size_t c = 0; c < n; ++c)
    {
      scaled[c] = residual[c] / diagonal[c];
    }
    return Product(scaled, residual);
  };
  double              rho = precondition();
  const double        goal = Tolerance * Tolerance * rho;
  std::vector<double> direction = scaled;
  for (int iteration = 0; iteration < MaximumIterations && rho > goal; ++iteration)
  {
    Displace(gradients, direction, displacements);
    for (std::size_t c = 0; c < n; ++c)
    {
      product[c] = Damping * diagonal[c] * direction[c];
    }
    for (const VolumeGradient & g : gradients)
    {
      product[g.cell] += Dot(g.gradient, displacements[g.point]);
    }
    const double step = rho / Product(direction, product);
    for (std::size_t c = 0; c < n; ++c)
    {
      pressures[c] += step * direction[c];
      residual[c] -= step * product[c];
    }
    const double old = rho;
    rho = precondition();
    for (std::size_t c = 0; c < n; ++c)
    {
      direction[c] = scaled[c] + rho / old * direction[c];
    }
  }
  Displace(gradients, pressures, displacements);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    mesh.points[p] = mesh.points[p] + displacements[p];
  }
}
} // namespace tissue
