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
/** The number of sweeps that average the corners that the image lacks. Chains of such corners are short, so that few
 * sweeps settle them. */
constexpr int NumberOfAveragingSweeps = 20;

double
DistanceToSegment(const Point & p, const Point & a, const Point & b)
{
  const Point  edge = b - a;
  const double squared = Dot(edge, edge);
  const double t = squared > 0.0 ? std::clamp(Dot(p - a, edge) / squared, 0.0, 1.0) : 0.0;
  return Distance(p, a + t * edge);
}

/** Finds the circumcentre of a triangle in its plane; returns false for a degenerate one, which has none. From a
 * corner, it is (|ab|^2 ac x n + |ac|^2 n x ab) / 2 |n|^2, where n = ab x ac. */
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

/** Finds the circumcentre of a tetrahedron; returns false for a flat one, which has none. From a corner, it is
 * (|ab|^2 ac x ad + |ac|^2 ad x ab + |ad|^2 ab x ac) / 2 ab . (ac x ad). */
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

/** Tells on which side of the plane through a triangle a point lies, by the sign of a sixfold volume. */
double
SideOf(const std::array<Point, 3> & t, const Point & p)
{
  return Dot(p - t[0], Cross(t[1] - t[0], t[2] - t[0]));
}
/** Returns the transform g of a canonical tetrahedron, in which the exterior, if it is there, is the first vertex. */
Point
CornerOfCenters(const VertexQuadruple & t, const JunctionSet & junctions)
{
  const auto                 center = [&junctions](VertexId v) { return junctions.CellOfVertex(v).center; };
  const std::array<Point, 3> others{ { center(t[1]), center(t[2]), center(t[3]) } };
  return t[0] == ExteriorVertex
           ? ProjectedCircumcenter(others)
           : ProjectedCircumcenter(std::array<Point, 4>{ { center(t[0]), others[0], others[1], others[2] } });
}

/** Puts each of the missing corners at the mean of the four corners whose tetrahedra are neighbours of its own. */
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

/** Puts every corner at the image's junction of its four cells, and those for which the image has none at the mean of
 * their neighbours. */
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

/** Moves corners that are at the same place a little towards the centres of their own cells, so that no edge between
 * them has the length 0. Several corners come to one place in a block of more than four cells, and at the middle of an
 * edge that several circumcentres are projected to. */
void
SeparateCoincident(const std::vector<VertexQuadruple> & tetrahedra, const JunctionSet & junctions,
                   std::vector<Point> & corners)
{
  // The share of the way to the mean of the centres that such a corner goes: enough to give the walls an area, and
  // little enough to leave the corner where the image has it.
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
  // The circumcentre is inside exactly where no angle is obtuse. Else the closest edge is the one opposite to the
  // obtuse angle, which is the longest.
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
