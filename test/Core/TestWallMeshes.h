/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TestWallMeshes_h
#define TestWallMeshes_h

#include "Dual/CellCorners.h"
#include "Dual/DualMesh.h"
#include "Remeshing/WallRefinement.h"
#include "RunBackwards.h"
#include "TestComplexes.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "WallMeshChecks.h"

/** Wall meshes for the tests of what is done with them. */
namespace tissue_test
{
using namespace tissue;

inline WallMesh
StarsOf(const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  return TriangulateAsStars(
    Dualize(complex, ComputeCorners(complex, JunctionsOf(complex, centers), CornerRule::ProjectedCircumcenter)));
}

inline WallMesh
RandomTissue(int numberOfCells)
{
  const auto centers = RandomCenters(numberOfCells, 1);
  return StarsOf(DelaunayComplex(centers), centers);
}

/** Four cells around a point and the exterior: ten flat walls of three corners each, stretched along the axes. */
inline WallMesh
FourCells(const Point & stretch = { { 1, 1, 1 } })
{
  const AdjacencyComplex   complex(5, FourSimplex());
  const std::vector<Point> centers = RegularTetrahedron();
  std::vector<Point>       corners;
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    Point sum{ { 0.0, 0.0, 0.0 } };
    for (const VertexId v : t)
    {
      sum = v == ExteriorVertex ? sum : sum + centers[v];
    }
    for (int i = 0; i < 3; ++i)
    {
      sum[i] *= stretch[i];
    }
    corners.push_back(sum);
  }
  return TriangulateAsStars(Dualize(complex, corners));
}

/** The unit ball in three slices, cells 1 to 3: all six walls have two corners, the poles 0 and 1, and there are four
 * lines from pole to pole, each in two pieces: the axis and three meridians. */
inline WallMesh
Orange()
{
  WallMesh mesh;
  mesh.points = { { { 0, 0, 1 } }, { { 0, 0, -1 } }, { { 0, 0, 0 } } };
  const double third = 2.0 * std::acos(-1.0) / 3.0;
  for (int i = 0; i < 3; ++i)
  {
    mesh.points.push_back({ { std::cos(i * third), std::sin(i * third), 0 } });
  }
  mesh.numberOfCells = { CellsAtCorner, CellsAtCorner, CellsOnLine, CellsOnLine, CellsOnLine, CellsOnLine };
  const auto addWall = [&mesh](VertexPair cells, PointId middle, PointId otherMiddle, const Point & center) {
    const PointId outline[] = { 0, middle, 1, otherMiddle };
    const auto    centerId = static_cast<PointId>(mesh.points.size());
    for (int i = 0; i < 4; ++i)
    {
      mesh.triangles.push_back({ { centerId, outline[i], outline[(i + 1) % 4] } });
      mesh.wallOfTriangle.push_back(static_cast<WallId>(mesh.walls.size()));
    }
    mesh.walls.push_back({ cells });
    mesh.points.push_back(center);
    mesh.numberOfCells.push_back(CellsWithinWall);
  };
  for (int i = 0; i < 3; ++i)
  {
    // Cell i + 1 lies between the meridians i and i + 1; its outer wall is counterclockwise seen from outside.
    const int   next = (i + 1) % 3;
    const Point middle = mesh.points[3 + i] + mesh.points[3 + next];
    addWall({ { i + 1, ExteriorVertex } }, 3 + i, 3 + next, Normalized(middle));
  }
  addWall({ { 1, 3 } }, 2, 3, 0.5 * mesh.points[3]);
  addWall({ { 1, 2 } }, 4, 2, 0.5 * mesh.points[4]);
  addWall({ { 2, 3 } }, 5, 2, 0.5 * mesh.points[5]);
  return mesh;
}

/** The orange with 4^numberOfSplits times the triangles, its outer walls on the sphere. */
inline WallMesh
RoundOrange(int numberOfSplits)
{
  WallMesh mesh = Orange();
  for (int i = 0; i < numberOfSplits; ++i)
  {
    SplitTriangles(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (const PointId p : mesh.triangles[t])
      {
        const bool outer = mesh.walls[mesh.wallOfTriangle[t]].cells[1] == ExteriorVertex;
        mesh.points[p] = outer ? Normalized(mesh.points[p]) : mesh.points[p];
      }
    }
  }
  return mesh;
}

/** No edge within a wall joins two points that another wall has too. */
inline void
ExpectNoChordOfOtherWalls(const WallMesh & mesh)
{
  std::map<PointId, std::set<WallId>>                walls;
  std::map<std::array<PointId, 2>, std::set<WallId>> wallsOfEdge;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto & triangle = mesh.triangles[t];
    for (int i = 0; i < 3; ++i)
    {
      walls[triangle[i]].insert(mesh.wallOfTriangle[t]);
      const PointId a = triangle[i];
      const PointId b = triangle[(i + 1) % 3];
      wallsOfEdge[{ { std::min(a, b), std::max(a, b) } }].insert(mesh.wallOfTriangle[t]);
    }
  }
  for (const auto & edge : wallsOfEdge)
  {
    const auto & ofA = walls[edge.first[0]];
    const auto & ofB = walls[edge.first[1]];
    const auto   common = std::count_if(ofA.begin(), ofA.end(), [&](WallId wall) { return ofB.count(wall) > 0; });
    EXPECT_TRUE(edge.second.size() == 3 || common == 1) << "edge " << edge.first[0] << " " << edge.first[1];
  }
}

inline void
ExpectSound(const WallMesh & mesh, VertexId numberOfCells)
{
  ExpectInvariants(mesh, numberOfCells + 1);
  EXPECT_TRUE(CheckCellSurfaces(mesh, numberOfCells + 1).IsSound());
  ExpectNoChordOfOtherWalls(mesh);
}
} // namespace tissue_test

#endif
