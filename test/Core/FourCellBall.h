/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef FourCellBall_h
#define FourCellBall_h

#include "TestComplexes.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

/** A ball of four equal cells around the origin, whose every corner, line and wall is known: cell i is where the i-th
 * vertex of a regular tetrahedron is nearest. */
namespace tissue_test
{
using namespace tissue;

constexpr double VoxelLength = 0.1;
constexpr double Radius = 1.5;

/** The first two axes are turned by a right angle. */
inline LabelVolume
MakeVolume()
{
  constexpr int            side = 36;
  const std::vector<Point> centers = RegularTetrahedron();
  LabelVolume              volume;
  volume.size = { { side, side, side } };
  volume.steps = { { { { 0.0, VoxelLength, 0.0 } }, { { -VoxelLength, 0.0, 0.0 } }, { { 0.0, 0.0, VoxelLength } } } };
  volume.origin = Point{ { 0.0, 0.0, 0.0 } } - volume.ToPhysical({ { 17.41, 17.23, 17.62 } }); // no voxel is on a wall
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        const Point p =
          volume.ToPhysical({ { static_cast<double>(x), static_cast<double>(y), static_cast<double>(z) } });
        const auto nearest =
          std::min_element(centers.begin() + 1, centers.end(), [&p](const Point & a, const Point & b) {
            return Distance(a, p) < Distance(b, p);
          });
        volume.vertices.push_back(Norm(p) < Radius ? static_cast<VertexId>(nearest - centers.begin()) : ExteriorVertex);
      }
    }
  }
  return volume;
}

inline AdjacencyComplex
MakeComplex()
{
  return AdjacencyComplex(5, FourSimplex());
}

/** In the order of AdjacencyComplex::GetTetrahedra(). */
inline std::vector<Point>
TrueCorners()
{
  const std::vector<Point> centers = RegularTetrahedron();
  std::vector<Point>       corners;
  for (const VertexQuadruple & t : MakeComplex().GetTetrahedra())
  {
    Point sum{ { 0.0, 0.0, 0.0 } };
    for (const VertexId v : t)
    {
      sum = v == ExteriorVertex ? sum : sum + centers[v];
    }
    corners.push_back(Norm(sum) > 0.5 ? Radius * Normalized(sum) : sum);
  }
  return corners;
}
} // namespace tissue_test

#endif
