/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/LineSubdivision.h"

#include "Mesh/WallLines.h"
#include "Mesh/WallMeshOrder.h"
#include "Remeshing/LineCoarsening.h"
#include "Remeshing/WallEdgeLengths.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tissue
{
namespace
{
/** A chain of points, with the length along it from its start to each of them. */
struct Polygon
{
  std::vector<Point>  points;
  std::vector<double> lengths;

  void
  Append(const Point & point)
  {
    lengths.push_back(points.empty() ? 0.0 : lengths.back() + Distance(points.back(), point));
    points.push_back(point);
  }

  /** Returns the point at a length from the start. */
  Point
  At(double length) const
  {
    const auto upper = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
    const auto i = static_cast<std::size_t>(upper - lengths.begin());
    const auto piece = lengths[i] - lengths[i - 1];
    const auto fraction = piece > 0.0 ? (length - lengths[i - 1]) / piece : 0.0;
    return points[i - 1] + fraction * (points[i] - points[i - 1]);
  }
};

/** A line to be cut: `segments` is what is wanted, Segments() what it has. */
struct Cut
{
  WallLine line;
  Polygon  polygon;
  /** The length along the polygon to each point of the line. */
  std::vector<double> lengths;
  std::size_t         segments = 1;

  std::size_t
  Segments() const
  {
    return line.points.size() - 1;
  }
  double
  WantedLength(std::size_t i) const
  {
    return polygon.lengths.back() * static_cast<double>(i) / static_cast<double>(this->Segments());
  }
  bool
  IsEven() const
  {
    // A share of the line's length: far below what can be seen, far above what rounding adds up to.
    constexpr double tolerance = 1e-6;
    for (std::size_t i = 1; i < this->Segments(); ++i)
    {
      if (std::abs(lengths[i] - this->WantedLength(i)) > tolerance * polygon.lengths.back())
      {
        return false;
      }
    }
    return true;
  }
};

/** An edge with its new points, which are in order from the smaller end to the larger. */
struct SplitEdge
{
  std::array<PointId, 2> ends;
  std::vector<PointId>   points;

  bool
  operator<(const SplitEdge & other) const
  {
    return ends < other.ends;
  }
};

std::vector<Cut>
PlanCuts(const WallMesh & mesh, const std::vector<double> & edgeLengths)
{
  std::vector<Cut>        cuts;
  std::vector<WallLine>   lines = CollectWallLines(mesh);
  const std::vector<bool> isDoubled = FindDoubledLines(lines);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    WallLine & line = lines[i];
    Cut        cut;
    for (const PointId p : line.points)
    {
      cut.polygon.Append(mesh.points[p]);
    }
    cut.lengths = cut.polygon.lengths;
    cut.segments =
      static_cast<std::size_t>(NumberOfSegments(cut.polygon.lengths.back(), EdgeLengthAt(line, edgeLengths)));
    cut.segments = std::max<std::size_t>(cut.segments, isDoubled[i] ? 2 : 1);
    cut.line = std::move(line);
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

/** Takes away as many points as the line has too many, as far as the triangles allow: first those that are farthest
 * from where a point is wanted. */
void
Coarsen(LineCoarsening & coarsening, Cut & cut)
{
  const double piece = cut.polygon.lengths.back() / static_cast<double>(cut.segments);
  const auto   misfit = [&](std::size_t i) {
    return std::abs(cut.lengths[i] - piece * std::round(cut.lengths[i] / piece));
  };
  while (cut.Segments() > cut.segments)
  {
    std::vector<std::size_t> order(cut.Segments() - 1);
    std::iota(order.begin(), order.end(), 1);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return misfit(i) > misfit(k); });
    const auto removed =
      std::find_if(order.begin(), order.end(), [&](std::size_t i) { return coarsening.RemovePoint(cut.line, i); });
    if (removed == order.end())
    {
      return;
    }
    cut.lengths.erase(cut.lengths.begin() + static_cast<std::ptrdiff_t>(*removed));
  }
}

/** Returns into how many pieces each segment of the line is to be cut, so that as many points come to lie in each as
 * are wanted there. */
std::vector<std::size_t>
ShareSegments(const Cut & cut)
{
  const double             piece = cut.polygon.lengths.back() / static_cast<double>(cut.segments);
  const auto               wantedUpTo = [&](std::size_t i) { return std::lround(cut.lengths[i] / piece); };
  std::vector<std::size_t> pieces(cut.Segments(), 1);
  std::size_t              count = pieces.size();
  for (std::size_t i = 0; i < pieces.size() && count < cut.segments; ++i)
  {
    const auto wanted = static_cast<std::size_t>(std::max(1L, wantedUpTo(i + 1) - wantedUpTo(i)));
    pieces[i] = std::min(wanted, cut.segments - count + 1);
    count += pieces[i] - 1;
  }
  // Where the segments before were too long for their place, the last one gets what is left.
  pieces.back() += cut.segments > count ? cut.segments - count : 0;
  return pieces;
}

/** Adds the points that a line has too few, and appends the edges that they split. The points of a segment divide it
 * evenly and lie on the polygon that the line was at first. */
void
AddPoints(WallMesh & mesh, Cut & cut, std::vector<SplitEdge> & edges)
{
  const std::vector<std::size_t> pieces = ShareSegments(cut);
  std::vector<PointId>           points{ cut.line.points[0] };
  std::vector<double>            lengths{ 0.0 };
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    SplitEdge    edge{ { { cut.line.points[i], cut.line.points[i + 1] } }, {} };
    const double start = cut.lengths[i];
    const double piece = (cut.lengths[i + 1] - start) / static_cast<double>(pieces[i]);
    for (std::size_t k = 1; k < pieces[i]; ++k)
    {
      edge.points.push_back(static_cast<PointId>(mesh.points.size()));
      lengths.push_back(start + static_cast<double>(k) * piece);
      mesh.points.push_back(cut.polygon.At(lengths.back()));
      mesh.numberOfCells.push_back(CellsOnLine);
    }
    points.insert(points.end(), edge.points.begin(), edge.points.end());
    points.push_back(cut.line.points[i + 1]);
    lengths.push_back(cut.lengths[i + 1]);
    if (edge.ends[0] > edge.ends[1])
    {
      std::swap(edge.ends[0], edge.ends[1]);
      std::reverse(edge.points.begin(), edge.points.end());
    }
    if (!edge.points.empty())
    {
      edges.push_back(std::move(edge));
    }
  }
  cut.line.points = std::move(points);
  cut.lengths = std::move(lengths);
}

/** Appends the triangle, or those it falls into: a fan over one of its split edges, whose triangles are cut further
 * where they have another one. */
void
AppendTriangle(const std::vector<SplitEdge> & edges, const Triangle & t, std::vector<Triangle> & triangles)
{
  for (int i = 0; i < 3; ++i)
  {
    const PointId   a = t[i];
    const PointId   b = t[(i + 1) % 3];
    const PointId   c = t[(i + 2) % 3];
    const SplitEdge key{ { { std::min(a, b), std::max(a, b) } }, {} };
    const auto      edge = std::lower_bound(edges.begin(), edges.end(), key);
    if (edge != edges.end() && edge->ends == key.ends)
    {
      std::vector<PointId> points = edge->points;
      if (a > b)
      {
        std::reverse(points.begin(), points.end());
      }
      points.push_back(b);
      PointId from = a;
      for (const PointId to : points)
      {
        AppendTriangle(edges, { { from, to, c } }, triangles);
        from = to;
      }
      return;
    }
  }
  triangles.push_back(t);
}

/** Splits the edges of the mesh, and drops the triangles that are gone. */
void
SplitTrianglesAt(WallMesh & mesh, std::vector<SplitEdge> & edges)
{
  std::sort(edges.begin(), edges.end());
  std::vector<Triangle> triangles;
  std::vector<WallId>   wallOfTriangle;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (!LineCoarsening::IsGone(mesh.triangles[t]))
    {
      AppendTriangle(edges, mesh.triangles[t], triangles);
      wallOfTriangle.resize(triangles.size(), mesh.wallOfTriangle[t]);
    }
  }
  mesh.triangles = std::move(triangles);
  mesh.wallOfTriangle = std::move(wallOfTriangle);
}

/** Moves the line's points towards equal lengths, each as far as the triangles and the order of the points allow: all
 * of the way, or a half, a quarter or an eighth of it. */
void
Slide(LineCoarsening & coarsening, Cut & cut)
{
  // A point that its neighbour blocks is free once that has moved, so that a few sweeps do; more would take time only
  // for lines that are stuck.
  constexpr int sweeps = 10;
  constexpr int steps = 4;
  for (int sweep = 0; sweep < sweeps && !cut.IsEven(); ++sweep)
  {
    for (std::size_t i = 1; i < cut.Segments(); ++i)
    {
      double part = cut.WantedLength(i) - cut.lengths[i];
      for (int step = 0; step < steps; ++step, part *= 0.5)
      {
        const double length = cut.lengths[i] + part;
        const bool   inOrder = cut.lengths[i - 1] < length && length < cut.lengths[i + 1];
        if (inOrder && coarsening.MovePoint(cut.line.points[i], cut.polygon.At(length)))
        {
          cut.lengths[i] = length;
          break;
        }
      }
    }
  }
}
} // namespace

void
SubdivideLines(WallMesh & mesh, const std::vector<double> & edgeLengths)
{
  RequireEdgeLengths(mesh, edgeLengths);
  std::vector<Cut> cuts = PlanCuts(mesh, edgeLengths);
  if (std::any_of(cuts.begin(), cuts.end(), [](const Cut & cut) { return cut.Segments() > cut.segments; }))
  {
    LineCoarsening coarsening(mesh);
    for (Cut & cut : cuts)
    {
      Coarsen(coarsening, cut);
    }
  }
  std::vector<SplitEdge> edges;
  for (Cut & cut : cuts)
  {
    AddPoints(mesh, cut, edges);
  }
  SplitTrianglesAt(mesh, edges);
  if (!std::all_of(cuts.begin(), cuts.end(), [](const Cut & cut) { return cut.IsEven(); }))
  {
    LineCoarsening coarsening(mesh);
    for (Cut & cut : cuts)
    {
      if (!cut.IsEven())
      {
        Slide(coarsening, cut);
      }
    }
  }
  PutLinePointsFirst(mesh);
}
} // namespace tissue
