/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/VolumeFitting.h"

#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/WallMeasures.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace tissue
{
namespace
{
constexpr int    MaximumIterations = 100;
constexpr double Tolerance = 1e-6;
constexpr double Damping = 1e-3;

/** How the volume of a cell changes with a point. */
struct VolumeGradient
{
  VertexId cell;
  Point    gradient;
};

/** Those of a point are at [first[p], first[p] + count[p]). */
struct VolumeGradients
{
  std::vector<std::size_t>    first;
  std::vector<std::uint8_t>   count;
  std::vector<VolumeGradient> all;

  template <typename TVisitor>
  void
  VisitPoint(std::size_t p, const TVisitor & visit) const
  {
    std::for_each_n(all.begin() + static_cast<std::ptrdiff_t>(first[p]), count[p], visit);
  }

  void
  Add(PointId p, VertexId cell, const Point & gradient)
  {
    if (cell == ExteriorVertex)
    {
      return;
    }
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first[p]);
    const auto end = begin + count[p];
    const auto at = std::find_if(begin, end, [cell](const VolumeGradient & g) { return g.cell == cell; });
    if (at != end)
    {
      at->gradient = at->gradient + gradient;
      return;
    }
    if (first[p] + count[p] == first[p + 1])
    {
      throw std::invalid_argument("FitVolumes: more cells meet at point " + std::to_string(p) +
                                  " than the mesh's numberOfCells tells");
    }
    *end = { cell, gradient };
    ++count[p];
  }
};

VolumeGradients
CollectGradients(const WallMesh & mesh)
{
  VolumeGradients gradients;
  gradients.first.resize(mesh.points.size() + 1, 0);
  std::inclusive_scan(mesh.numberOfCells.begin(),
                      mesh.numberOfCells.end(),
                      gradients.first.begin() + 1,
                      std::plus<std::size_t>(),
                      std::size_t{ 0 });
  gradients.count.resize(mesh.points.size(), 0);
  gradients.all.resize(gradients.first.back());
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
      gradients.Add(triangle[i], cells[0], g);
      gradients.Add(triangle[i], cells[1], -1.0 * g);
    }
  }
  return gradients;
}

/** How the volume of each cell changes with the pressure in each: a symmetric matrix, sparse as cells have few
 * neighbours. */
class PressureMatrix
{
public:
  PressureMatrix(std::size_t numberOfVertices, const VolumeGradients & gradients)
    : m_Diagonal(numberOfVertices, 0.0)
    , m_Upper(numberOfVertices)
  {
    for (std::size_t p = 0; p < gradients.count.size(); ++p)
    {
      gradients.VisitPoint(p, [&](const VolumeGradient & a) {
        gradients.VisitPoint(p, [&](const VolumeGradient & b) {
          if (a.cell <= b.cell)
          {
            this->Add(a.cell, b.cell, Dot(a.gradient, b.gradient));
          }
        });
      });
    }
  }

  double
  Diagonal(std::size_t cell) const
  {
    return m_Diagonal[cell] > 0.0 ? m_Diagonal[cell] : 1.0;
  }

  /** With the diagonal a little larger, as volumes of cells that enclose each other depend on each other. */
  std::vector<double>
  TimesDamped(const std::vector<double> & pressures) const
  {
    std::vector<double> changes(pressures.size());
    for (std::size_t a = 0; a < pressures.size(); ++a)
    {
      changes[a] = (m_Diagonal[a] + Damping * this->Diagonal(a)) * pressures[a];
    }
    for (std::size_t a = 0; a < pressures.size(); ++a)
    {
      for (const auto & [b, value] : m_Upper[a])
      {
        changes[a] += value * pressures[b];
        changes[b] += value * pressures[a];
      }
    }
    return changes;
  }

private:
  void
  Add(VertexId a, VertexId b, double value)
  {
    if (a == b)
    {
      m_Diagonal[a] += value;
      return;
    }
    auto &     row = m_Upper[a];
    const auto at = std::find_if(row.begin(), row.end(), [b](const auto & entry) { return entry.first == b; });
    if (at != row.end())
    {
      at->second += value;
    }
    else
    {
      row.emplace_back(b, value);
    }
  }

  std::vector<double>                                   m_Diagonal;
  std::vector<std::vector<std::pair<VertexId, double>>> m_Upper;
};

double
Product(const std::vector<double> & a, const std::vector<double> & b)
{
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/** By conjugate gradients, preconditioned by the diagonal. */
std::vector<double>
SolveForPressures(const PressureMatrix & matrix, std::vector<double> residual)
{
  const std::size_t   n = residual.size();
  std::vector<double> pressures(n, 0.0);
  std::vector<double> scaled(n);
  const auto          precondition = [&]() {
    for (std::size_t c = 0; c < n; ++c)
    {
      scaled[c] = residual[c] / matrix.Diagonal(c);
    }
    return Product(scaled, residual);
  };
  double              rho = precondition();
  const double        goal = Tolerance * Tolerance * rho;
  std::vector<double> direction = scaled;
  for (int iteration = 0; iteration < MaximumIterations && rho > goal; ++iteration)
  {
    const std::vector<double> product = matrix.TimesDamped(direction);
    const double              step = rho / Product(direction, product);
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
  return pressures;
}
} // namespace

void
FitVolumes(WallMesh & mesh, const std::vector<double> & volumes, double largestShare)
{
  const VolumeGradients     gradients = CollectGradients(mesh);
  const std::vector<double> current = ComputeVolumes(mesh, volumes.size());
  std::vector<double>       wanted(volumes.size(), 0.0);
  for (std::size_t c = ExteriorVertex + 1; c < volumes.size(); ++c)
  {
    const double cap = largestShare * volumes[c];
    wanted[c] = volumes[c] > 0.0 ? std::clamp(volumes[c] - current[c], -cap, cap) : 0.0;
  }
  const std::vector<double> pressures = SolveForPressures(PressureMatrix(volumes.size(), gradients), wanted);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    gradients.VisitPoint(
      p, [&](const VolumeGradient & g) { mesh.points[p] = mesh.points[p] + pressures[g.cell] * g.gradient; });
  }
}
} // namespace tissue
