/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WallSheets_h
#define WallSheets_h

#include "Geometry/TriangleCrossing.h"
#include "Mesh/Crossings.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue_test
{
using namespace tissue;

/** Adds a wall of 2 x n x n triangles over the square [0, n] x [0, n] at a height. */
inline void
AddSheet(WallMesh & mesh, int n, double height)
{
  const auto first = static_cast<PointId>(mesh.points.size());
  const auto wall = static_cast<WallId>(mesh.walls.size());
  for (int y = 0; y <= n; ++y)
  {
    for (int x = 0; x <= n; ++x)
    {
      const bool isRim = x == 0 || y == 0 || x == n || y == n;
      mesh.points.push_back({ { static_cast<double>(x), static_cast<double>(y), height } });
      mesh.numberOfCells.push_back(isRim ? CellsOnLine : CellsWithinWall);
    }
  }
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      const PointId a = first + y * (n + 1) + x;
      const PointId b = a + n + 1;
      mesh.triangles.push_back({ { a, a + 1, b } });
      mesh.triangles.push_back({ { a + 1, b + 1, b } });
      mesh.wallOfTriangle.insert(mesh.wallOfTriangle.end(), 2, wall);
    }
  }
  mesh.walls.emplace_back();
}

/** Moves each point by up to this along each axis. */
inline void
Shake(WallMesh & mesh, double most, Random & random)
{
  for (Point & p : mesh.points)
  {
    for (double & coordinate : p)
    {
      coordinate += most * (2.0 * random.Uniform() - 1.0);
    }
  }
}

/** The pairs of triangles that cross, each pair tested. */
inline std::vector<TrianglePair>
FindCrossingsOneByOne(const WallMesh & mesh)
{
  std::vector<TrianglePair> pairs;
  const auto                count = static_cast<std::int32_t>(mesh.triangles.size());
  for (std::int32_t a = 0; a < count; ++a)
  {
    for (std::int32_t b = a + 1; b < count; ++b)
    {
      if (TrianglesCross(mesh.points, mesh.triangles[a], mesh.triangles[b]))
      {
        pairs.push_back({ { a, b } });
      }
    }
  }
  return pairs;
}
} // namespace tissue_test

#endif
