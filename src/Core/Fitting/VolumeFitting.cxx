/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/VolumeFitting.h"

#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "Mesh/WallMeasures.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
/** The most iterations of the conjugate gradients. Cells have few neighbours, and tens suffice. */
constexpr int MaximumIterations = 100;
/** The residual of the pressures over the wanted changes of volume at which the iterations end. Steps are exact to
 * first order only, so a smaller one would gain nothing. */
constexpr double Tolerance = 1e-6;
/** What is added to the diagonal of the matrix, over the diagonal: volumes of cells that enclose each other depend on
 * each other, and the matrix would be singular. */
constexpr double Damping = 1e-3;

/** How the volume of a cell changes with a point. */
struct VolumeGradient
{
  VertexId cell = ExteriorVertex;
  Point    gradient{ { 0.0, 0.0, 0.0 } };
};

/** Those of each point, in a place for each cell there; those of the exterior are zero. */
using VolumeGradients = CompressedRows<VolumeGradient>;

void
Add(VolumeGradients & gradients, PointId p, VertexId cell, const Point & gradient)
{
  if (cell == ExteriorVertex)
  {
    return;
  }
  for (VolumeGradient & place : gradients[static_cast<std::size_t>(p)])
  {
    if (place.cell == cell || place.cell == ExteriorVertex)
    {
      place = { cell, place.gradient + gradient };
      return;
    }
  }
  throw std::invalid_argument("FitVolumes: more cells meet at point " + std::to_string(p) +
                              " than the mesh's numberOfCells tells");
}

VolumeGradients
CollectGradients(const WallMesh & mesh)
{
  VolumeGradients gradients(mesh.points.size(), [&mesh](const auto & add) {
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      for (int cell = 0; cell < mesh.numberOfCells[p]; ++cell)
      {
        add(p, VolumeGradient());
      }
    }
  });
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
      Add(gradients, triangle[i], cells[0], g);
      Add(gradients, triangle[i], cells[1], -1.0 * g);
    }
  }
  return gradients;
}

/** How the volume of each cell changes with the pressure in each: a symmetric matrix, of which only the lower half is
 * kept, sparse as cells have few neighbours. */
Eigen::SparseMatrix<double>
MakePressureMatrix(std::size_t numberOfVertices, const VolumeGradients & gradients)
{
  std::vector<Eigen::Triplet<double>> entries;
  // Most points are within a wall, of two cells.
  entries.reserve(numberOfVertices + 2 * gradients.Items().size());
  for (std::size_t c = 0; c < numberOfVertices; ++c)
  {
    entries.emplace_back(static_cast<VertexId>(c), static_cast<VertexId>(c), 0.0);
  }
  for (std::size_t p = 0; p < gradients.NumberOfRows(); ++p)
  {
    for (const VolumeGradient & a : gradients[p])
    {
      for (const VolumeGradient & b : gradients[p])
      {
        if (b.cell <= a.cell && b.cell != ExteriorVertex)
        {
          entries.emplace_back(a.cell, b.cell, Dot(a.gradient, b.gradient));
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(static_cast<VertexId>(numberOfVertices), static_cast<VertexId>(numberOfVertices));
  matrix.setFromTriplets(entries.begin(), entries.end());
  // The diagonal a little larger, as volumes of cells that enclose each other depend on each other. It is zero for what
  // has no walls, the exterior for one, whose pressure does not matter.
  for (VertexId c = 0; c < matrix.rows(); ++c)
  {
    double & diagonal = matrix.coeffRef(c, c);
    diagonal = diagonal > 0.0 ? (1.0 + Damping) * diagonal : 1.0;
  }
  return matrix;
}
} // namespace

void
FitVolumes(WallMesh & mesh, const std::vector<double> & volumes, double largestShare)
{
  const VolumeGradients     gradients = CollectGradients(mesh);
  const std::vector<double> current = ComputeVolumes(mesh, volumes.size());
  Eigen::VectorXd           wanted = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(volumes.size()));
  for (std::size_t c = ExteriorVertex + 1; c < volumes.size(); ++c)
  {
    const double cap = largestShare * volumes[c];
    wanted[static_cast<Eigen::Index>(c)] = volumes[c] > 0.0 ? std::clamp(volumes[c] - current[c], -cap, cap) : 0.0;
  }
  // Preconditioned by the diagonal.
  const Eigen::SparseMatrix<double>                     matrix = MakePressureMatrix(volumes.size(), gradients);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>> solver;
  solver.setMaxIterations(MaximumIterations);
  solver.setTolerance(Tolerance);
  solver.compute(matrix);
  const Eigen::VectorXd pressures = solver.solve(wanted);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    for (const VolumeGradient & g : gradients[p])
    {
      mesh.points[p] = mesh.points[p] + pressures[g.cell] * g.gradient;
    }
  }
}
} // namespace tissue
