/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WallMeshChecks_h
#define WallMeshChecks_h

#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

/** What the class comment of WallMesh promises, checked from scratch. */
namespace tissue_test
{
using namespace tissue;
using DirectedEdge = std::array<PointId, 2>;
using Triangles = std::vector<Triangle>;

/** The triangles of a wall. */
inline Triangles
TrianglesOfWall(const WallMesh & mesh, WallId wall)
{
  Triangles triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (mesh.wallOfTriangle[t] == wall)
    {
      triangles.push_back(mesh.triangles[t]);
    }
  }
  return triangles;
}

/** The triangles around a cell, all with their normals away from it. */
inline Triangles
SurfaceOfCell(const WallMesh & mesh, VertexId cell)
{
  Triangles triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
    auto               triangle = mesh.triangles[t];
    if (cells[0] == cell || cells[1] == cell)
    {
      if (cells[1] == cell)
      {
        std::swap(triangle[1], triangle[2]);
      }
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/** By the divergence theorem. */
inline double
VolumeOf(const WallMesh & mesh, VertexId cell)
{
  double volume = 0.0;
  for (const auto & t : SurfaceOfCell(mesh, cell))
  {
    volume += Dot(mesh.points[t[0]], Cross(mesh.points[t[1]], mesh.points[t[2]])) / 6.0;
  }
  return volume;
}

/** Checks an oriented surface: every edge passed at most once in each direction, in one piece; returns the number of
 * border edges and sets the Euler characteristic. */
inline std::size_t
CheckSurface(const Triangles & triangles, long & euler)
{
  std::set<DirectedEdge>               directed;
  std::map<PointId, std::set<PointId>> adjacent;
  for (const auto & t : triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId a = t[i];
      const PointId b = t[(i + 1) % 3];
      EXPECT_TRUE(directed.insert(DirectedEdge{ { a, b } }).second)
        << "edge " << a << " " << b << " twice in one direction";
      adjacent[a].insert(b);
      adjacent[b].insert(a);
    }
  }
  std::size_t border = 0;
  for (const auto & edge : directed)
  {
    border += 1 - directed.count(DirectedEdge{ { edge[1], edge[0] } });
  }
  std::set<PointId>    reached{ adjacent.begin()->first };
  std::vector<PointId> open{ adjacent.begin()->first };
  while (!open.empty())
  {
    const PointId p = open.back();
    open.pop_back();
    for (const PointId q : adjacent[p])
    {
      if (reached.insert(q).second)
      {
        open.push_back(q);
      }
    }
  }
  EXPECT_EQ(reached.size(), adjacent.size()) << "several pieces";
  const auto edges = (directed.size() + border) / 2;
  euler = static_cast<long>(adjacent.size()) - static_cast<long>(edges) + static_cast<long>(triangles.size());
  return border;
}

/** Disks, closed spheres, conventions of the walls, and the number of cells at each point. */
inline void
ExpectInvariants(const WallMesh & mesh, VertexId numberOfCells)
{
  ASSERT_EQ(mesh.wallOfTriangle.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.numberOfCells.size(), mesh.points.size());
  EXPECT_TRUE(std::is_sorted(mesh.wallOfTriangle.begin(), mesh.wallOfTriangle.end()));
  long euler = 0;
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    const VertexPair & cells = mesh.walls[w].cells;
    EXPECT_NE(cells[0], ExteriorVertex) << "wall " << w;
    EXPECT_TRUE(cells[1] == ExteriorVertex || cells[0] < cells[1]) << "wall " << w;
    EXPECT_GE(CheckSurface(TrianglesOfWall(mesh, static_cast<WallId>(w)), euler), 3u) << "wall " << w;
    EXPECT_EQ(euler, 1) << "wall " << w;
  }
  for (VertexId cell = 0; cell < numberOfCells; ++cell)
  {
    EXPECT_EQ(CheckSurface(SurfaceOfCell(mesh, cell), euler), 0u) << "cell " << cell;
    EXPECT_EQ(euler, 2) << "cell " << cell;
  }
  std::vector<std::set<VertexId>> cellsAt(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
      cellsAt[p].insert(cells.begin(), cells.end());
    }
  }
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    EXPECT_EQ(cellsAt[p].size(), mesh.numberOfCells[p]) << "point " << p;
  }
}
} // namespace tissue_test

#endif
