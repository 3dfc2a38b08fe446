/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/CellCorners.h"

#include "Dual/SurfaceLift.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** Sweeps of averaging for the corners that the image lacks: chains of such corners are short. */
constexpr int NumberOfAveragingSweeps = 20;

double
DistanceToSegment(const Point & p, const Point & a, const Point & b)
{
  const Point  edge = b - a;
  const double squared = Dot(edge, edge);
  const double t = squared > 0.0 ? std::clamp(Dot(p - a, edge) / squared, 0.0, 1.0) : 0.0;
  return Distance(p, a + t * edge);
}

/** Circumcentre of a triangle in its plane; false for a degenerate one. */
bool
Circumcenter(const std::array<Point, 3> & t, Point & center)
{
  const Point  ab = t[1] - t[0];
  const Point  ac = t[2] - t[0];
  const Point  normal = Cross(ab, ac);
  const double scale = 2.0 * Dot(normal, normal);
  if (!(scale > 0.0))
  {
    return false;
  }
  center = t[0] + (1.0 / scale) * (Dot(ab, ab) * Cross(ac, normal) + Dot(ac, ac) * Cross(normal, ab));
  return true;
}

bool
Circumcenter(const std::array<Point, 4> & t, Point & center)
{
  const Point  ab = t[1] - t[0];
  const Point  ac = t[2] - t[0];
  const Point  ad = t[3] - t[0];
  const double sixfoldVolume = Dot(ab, Cross(ac, ad));
  if (sixfoldVolume == 0.0)
  {
    return false;
  }
  center = t[0] + (0.5 / sixfoldVolume) *
                    (Dot(ab, ab) * Cross(ac, ad) + Dot(ac, ac) * Cross(ad, ab) + Dot(ad, ad) * Cross(ab, ac));
  return std::isfinite(center[0]) && std::isfinite(center[1]) && std::isfinite(center[2]);
}

double
DistanceToTriangle(const Point & p, const std::array<Point, 3> & t)
{
  const Point normal = Normalized(Cross(t[1] - t[0], t[2] - t[0]));
  bool        inside = true;
  double      toEdges = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const Point & a = t[i];
    const Point & b = t[(i + 1) % 3];
    inside = inside && Dot(Cross(b - a, p - a), normal) >= 0.0;
    toEdges = std::min(toEdges, DistanceToSegment(p, a, b));
  }
  return inside ? std::abs(Dot(p - t[0], normal)) : toEdges;
}

/** The side of a plane through a triangle on which a point lies, as a signed sixfold volume. */
double
SideOf(const std::array<Point, 3> & t, const Point & p)
{
  return Dot(p - t[0], Cross(t[1] - t[0], t[2] - t[0]));
}
/** The transform g of a canonical tetrahedron, whose first vertex is the exterior where it has it. */
Point
CornerOfCenters(const VertexQuadruple & t, const JunctionSet & junctions)
{
  const auto                 center = [&junctions](VertexId v) { return junctions.CellOfVertex(v).center; };
  const std::array<Point, 3> others{ { center(t[1]), center(t[2]), center(t[3]) } };
  return t[0] == ExteriorVertex
           ? ProjectedCircumcenter(others)
           : ProjectedCircumcenter(std::array<Point, 4>{ { center(t[0]), others[0], others[1], others[2] } });
}

/** Puts the given corners at the mean of the four corners that a triangle of the complex joins them to. */
void
AverageNeighbors(const AdjacencyComplex & complex, const std::vector<std::size_t> & missing,
                 std::vector<Point> & corners)
{
  const std::vector<std::int32_t> ranks = complex.GetTetrahedronRanks();
  std::vector<TetrahedronId>      idOfRank(corners.size());
  for (std::size_t id = 0; id < ranks.size(); ++id)
  {
    if (ranks[id] >= 0)
    {
      idOfRank[ranks[id]] = static_cast<TetrahedronId>(id);
    }
  }
  for (int sweep = 0; sweep < NumberOfAveragingSweeps; ++sweep)
  {
    for (const std::size_t i : missing)
    {
      Point sum{ { 0.0, 0.0, 0.0 } };
      for (const TetrahedronId neighbor : complex.GetTetrahedron(idOfRank[i]).neighbors)
      {
        sum = sum + corners[ranks[neighbor]];
      }
      corners[i] = 0.25 * sum;
    }
  }
}

/** Puts every corner at the image's junction of its four cells, and averages those that the image has not. */
void
MoveToJunctions(const AdjacencyComplex & complex, const std::vector<VertexQuadruple> & tetrahedra,
                const JunctionSet & junctions, std::vector<Point> & corners)
{
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < tetrahedra.size(); ++i)
  {
    if (const Junction * const junction = FindJunction(junctions, tetrahedra[i]))
    {
      corners[i] = junction->position;
    }
    else
    {
      missing.push_back(i);
    }
  }
  AverageNeighbors(complex, missing, corners);
}

/** A block of more than four cells is the place of several corners, and so is the middle of an edge that several
 * circumcentres are projected to: moves each of them a little towards the centres of its own cells, so that no edge
 * between them has length 0. */
void
SeparateCoincident(const std::vector<VertexQuadruple> & tetrahedra, const JunctionSet & junctions,
                   std::vector<Point> & corners)
{
  constexpr double         share = 0.05;
  std::map<Point, int>     counts;
  const std::vector<Point> old = corners;
  for (const Point & corner : old)
  {
    ++counts[corner];
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (counts[old[i]] > 1)
    {
      Point  sum{ { 0.0, 0.0, 0.0 } };
      double n = 0.0;
      for (const VertexId v : tetrahedra[i])
      {
        if (v != ExteriorVertex)
        {
          sum = sum + junctions.CellOfVertex(v).center;
          n += 1.0;
        }
      }
      corners[i] = old[i] + share * ((1.0 / n) * sum - old[i]);
    }
  }
}
} // namespace

Point
ProjectedCircumcenter(const std::array<Point, 3> & t)
{
  // The circumcentre is inside exactly where no angle is obtuse; else the closest edge is the one opposite, the
  // longest.
  int    longest = 0;
  double squared[3];
  for (int i = 0; i < 3; ++i)
  {
    const Point edge = t[(i + 1) % 3] - t[i];
    squared[i] = Dot(edge, edge);
    longest = squared[i] > squared[longest] ? i : longest;
  }
  const double others = squared[0] + squared[1] + squared[2] - squared[longest];
  Point        center;
  if (squared[longest] < others && Circumcenter(t, center))
  {
    return center;
  }
  return 0.5 * (t[longest] + t[(longest + 1) % 3]);
}

Point
ProjectedCircumcenter(const std::array<Point, 4> & t)
{
  Point center;
  if (!Circumcenter(t, center))
  {
    return 0.25 * (t[0] + t[1] + t[2] + t[3]);
  }
  bool                 inside = true;
  double               least = std::numeric_limits<double>::infinity();
  std::array<Point, 3> closest{};
  for (int i = 0; i < 4; ++i)
  {
    const VertexTriple         f = TriangleOpposite({ { 0, 1, 2, 3 } }, i);
    const std::array<Point, 3> triangle{ { t[f[0]], t[f[1]], t[f[2]] } };
    inside = inside && SideOf(triangle, center) * SideOf(triangle, t[i]) >= 0.0;
    const double distance = DistanceToTriangle(center, triangle);
    if (distance < least)
    {
      least = distance;
      closest = triangle;
    }
  }
  return inside ? center : ProjectedCircumcenter(closest);
}

std::vector<Point>
ComputeCorners(const AdjacencyComplex & complex, const JunctionSet & junctions, CornerRule rule)
{
  const std::vector<VertexQuadruple> tetrahedra = complex.GetTetrahedra();
  std::vector<Point>                 corners;
  corners.reserve(tetrahedra.size());
  for (const VertexQuadruple & t : tetrahedra)
  {
    corners.push_back(CornerOfCenters(t, junctions));
  }
  if (rule == CornerRule::ImageJunction)
  {
    MoveToJunctions(complex, tetrahedra, junctions, corners);
  }
  if (rule == CornerRule::LiftedCircumcenter)
  {
    std::vector<Point> centers;
    for (VertexId v = ExteriorVertex; v < junctions.NumberOfVertices(); ++v)
    {
      centers.push_back(junctions.CellOfVertex(v).center);
    }
    LiftSurfaceCorners(complex, centers, corners);
  }
  SeparateCoincident(tetrahedra, junctions, corners);
  return corners;
}
} // namespace tissue
