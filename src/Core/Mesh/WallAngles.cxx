/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Mesh/WallAngles.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>

namespace tissue
{
namespace
{
constexpr double DegreesPerRadian = 57.29577951308232;

/** The angle between two vectors of any length, in degrees; exact near 0, too. */
double
AngleBetween(const Point & a, const Point & b)
{
  return DegreesPerRadian * std::atan2(Norm(Cross(a, b)), Dot(a, b));
}

/** A triangle at an edge, and its point that is not on it. */
struct Leaf
{
  std::int32_t triangle;
  PointId      apex;
};

struct EdgeLeaf
{
  PointId upper;
  Leaf    leaf;
};

/** Calls visit(lower point, upper point, leaves) for every edge, in ascending order. */
template <typename TVisitor>
void
ForEachEdge(const WallMesh & mesh, const TVisitor & visit)
{
  const CompressedRows<EdgeLeaf> leavesOf(mesh.points.size(), [&mesh](const auto & add) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const PointId a = mesh.triangles[t][i];
        const PointId b = mesh.triangles[t][(i + 1) % 3];
        add(static_cast<std::size_t>(std::min(a, b)),
            EdgeLeaf{ std::max(a, b), { static_cast<std::int32_t>(t), mesh.triangles[t][(i + 2) % 3] } });
      }
    }
  });
  std::vector<EdgeLeaf>          edges;
  std::vector<Leaf>              leaves;
  for (std::size_t lower = 0; lower < mesh.points.size(); ++lower)
  {
    edges.assign(leavesOf[lower].begin(), leavesOf[lower].end());
    std::stable_sort(
      edges.begin(), edges.end(), [](const EdgeLeaf & a, const EdgeLeaf & b) { return a.upper < b.upper; });
    for (std::size_t i = 0; i < edges.size();)
    {
      leaves.clear();
      const PointId upper = edges[i].upper;
      for (; i < edges.size() && edges[i].upper == upper; ++i)
      {
        leaves.push_back(edges[i].leaf);
      }
      visit(static_cast<PointId>(lower), upper, leaves);
    }
  }
}

/** The cell on that side of a leaf where another leaf of its edge is. */
VertexId
CellBetween(const WallMesh & mesh, const Leaf & leaf, const Leaf & other)
{
  const Triangle & t = mesh.triangles[static_cast<std::size_t>(leaf.triangle)];
  const Point      normal = Cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
  const bool       isInFront = Dot(normal, mesh.points[other.apex] - mesh.points[t[0]]) > 0.0;
  return mesh.walls[mesh.wallOfTriangle[static_cast<std::size_t>(leaf.triangle)]].cells[isInFront ? 1 : 0];
}

/** Calls visit(first leaf, second leaf, angle) for every two triangles at an edge: the least angle of a cell is one of
 * these. */
template <typename TVisitor>
void
ForEachDihedral(const WallMesh & mesh, PointId lower, PointId upper, const std::vector<Leaf> & leaves,
                const TVisitor & visit)
{
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    for (std::size_t j = i + 1; j < leaves.size(); ++j)
    {
      const double angle =
        DihedralAngle(mesh.points[lower], mesh.points[upper], mesh.points[leaves[i].apex], mesh.points[leaves[j].apex]);
      visit(leaves[i], leaves[j], angle);
    }
  }
}
} // namespace

double
LeastAngle(const Point & a, const Point & b, const Point & c)
{
  return std::min({ AngleBetween(b - a, c - a), AngleBetween(c - b, a - b), AngleBetween(a - c, b - c) });
}

double
DihedralAngle(const Point & a, const Point & b, const Point & c, const Point & d)
{
  const Point axis = b - a;
  return AngleBetween(Cross(axis, c - a), Cross(axis, d - a));
}

double
MedianEdgeLength(const WallMesh & mesh)
{
  std::vector<double> lengths;
  ForEachEdge(mesh, [&](PointId lower, PointId upper, const std::vector<Leaf> &) {
    lengths.push_back(Distance(mesh.points[lower], mesh.points[upper]));
  });
  return lengths.empty() ? 0.0 : Median(lengths);
}

WallAngles
MeasureWallAngles(const WallMesh & mesh, VertexId numberOfVertices)
{
  WallAngles angles;
  angles.minimumDihedralOfCell.assign(static_cast<std::size_t>(numberOfVertices), 180.0);
  for (const Triangle & t : mesh.triangles)
  {
    angles.minimumTriangleAngle =
      std::min(angles.minimumTriangleAngle, LeastAngle(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]));
  }
  std::vector<double> lengths;
  ForEachEdge(mesh, [&](PointId lower, PointId upper, const std::vector<Leaf> & leaves) {
    lengths.push_back(Distance(mesh.points[lower], mesh.points[upper]));
    ForEachDihedral(mesh, lower, upper, leaves, [&](const Leaf & a, const Leaf & b, double angle) {
      const VertexId cell = CellBetween(mesh, a, b);
      double &       least = angles.minimumDihedralOfCell[static_cast<std::size_t>(cell)];
      least = cell == ExteriorVertex ? least : std::min(least, angle);
    });
  });
  if (!lengths.empty())
  {
    const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end());
    angles.shortestEdge = *least;
    angles.longestEdge = *most;
    angles.medianEdge = Median(lengths);
  }
  for (const double angle : angles.minimumDihedralOfCell)
  {
    angles.minimumDihedralAngle = std::min(angles.minimumDihedralAngle, angle);
  }
  return angles;
}

std::vector<SharpPlace>
FindSharpPlaces(const WallMesh & mesh, const AngleLimits & limits)
{
  std::vector<SharpPlace> places;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle & p = mesh.triangles[t];
    const double     angle = LeastAngle(mesh.points[p[0]], mesh.points[p[1]], mesh.points[p[2]]);
    if (!(angle >= limits.triangleAngle))
    {
      const WallId wall = mesh.wallOfTriangle[t];
      places.push_back({ SharpPlace::Kind::TriangleAngle, angle, mesh.walls[wall].cells[0], wall, p });
    }
  }
  const double median = MedianEdgeLength(mesh);
  ForEachEdge(mesh, [&](PointId lower, PointId upper, const std::vector<Leaf> & leaves) {
    const Triangle edge{ { lower, upper, -1 } };
    const WallId   first = mesh.wallOfTriangle[static_cast<std::size_t>(leaves[0].triangle)];
    const double   length = Distance(mesh.points[lower], mesh.points[upper]) / median;
    if (!(length >= limits.edgeLength))
    {
      places.push_back({ SharpPlace::Kind::EdgeLength, length, mesh.walls[first].cells[0], first, edge });
    }
    ForEachDihedral(mesh, lower, upper, leaves, [&](const Leaf & a, const Leaf & b, double angle) {
      if (!(angle >= limits.dihedralAngle))
      {
        const WallId wall = mesh.wallOfTriangle[static_cast<std::size_t>(a.triangle)];
        places.push_back({ SharpPlace::Kind::DihedralAngle, angle, CellBetween(mesh, a, b), wall, edge });
      }
    });
  });
  return places;
}
} // namespace tissue
