/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/AngleMending.h"

#include "Common/Algorithms.h"
#include "Fitting/LoosePoints.h"
#include "Mesh/Crossings.h"
#include "Mesh/WallMeshOrder.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace tissue
{
namespace
{
constexpr int MaximumNumberOfRounds = 12;
/** What is mended gets better than the limits by this factor, so that later small steps do not undo it. */
constexpr double Margin = 1.15;
/** A change must leave this share of what is too sharp, or less. */
constexpr double LeastGain = 0.99;
/** The lengths of the moves that are tried, over the mean edge at the point. */
constexpr double Steps[] = { 0.3, 0.1, 0.03 };

/** \brief One mesh, while places of it are mended. */
class Mending
{
public:
  Mending(WallMesh & mesh, const AngleLimits & limits, double medianEdge)
    : m_Mesh(mesh)
    , m_Limits{ Margin * limits.triangleAngle, Margin * limits.dihedralAngle, Margin * limits.edgeLength * medianEdge }
    , m_TrianglesAt(mesh.points.size())
    , m_IsGone(mesh.triangles.size(), false)
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (const PointId p : mesh.triangles[t])
      {
        m_TrianglesAt[p].push_back(static_cast<std::int32_t>(t));
      }
    }
  }

  /** Mends what is at some points. The mesh may have triangles that are gone, until TakeAway(). */
  void
  MendAt(const std::vector<LoosePoint> & loose)
  {
    for (const LoosePoint & entry : loose)
    {
      m_Loose[entry.point] = &entry;
    }
    for (const LoosePoint & entry : loose)
    {
      if (!m_TrianglesAt[entry.point].empty() && this->ExcessAt(entry.point) > 0.0)
      {
        this->Flip(entry.point);
        this->Collapse(entry.point);
      }
    }
    for (const LoosePoint & entry : loose)
    {
      this->Move(entry);
    }
  }

  /** Triangles and points that are gone. Returns the points that stay, by their numbers before. */
  std::vector<PointId>
  TakeAway()
  {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < m_Mesh.triangles.size(); ++t)
    {
      if (!m_IsGone[t])
      {
        m_Mesh.triangles[kept] = m_Mesh.triangles[t];
        m_Mesh.wallOfTriangle[kept++] = m_Mesh.wallOfTriangle[t];
      }
    }
    m_Mesh.triangles.resize(kept);
    m_Mesh.wallOfTriangle.resize(kept);
    std::vector<PointId> order;
    for (std::size_t p = 0; p < m_TrianglesAt.size(); ++p)
    {
      if (!m_TrianglesAt[p].empty())
      {
        order.push_back(static_cast<PointId>(p));
      }
    }
    TakePoints(m_Mesh, order);
    return order;
  }

private:
  const Point &
  At(PointId p) const
  {
    return m_Mesh.points[static_cast<std::size_t>(p)];
  }

  /** The triangle's point that is none of the two. */
  PointId
  Apex(std::int32_t t, PointId a, PointId b) const
  {
    for (const PointId p : m_Mesh.triangles[t])
    {
      if (p != a && p != b)
      {
        return p;
      }
    }
    return -1;
  }

  bool
  Has(std::int32_t t, PointId p) const
  {
    const Triangle & triangle = m_Mesh.triangles[t];
    return triangle[0] == p || triangle[1] == p || triangle[2] == p;
  }

  std::vector<std::int32_t>
  LeavesOf(PointId a, PointId b) const
  {
    std::vector<std::int32_t> leaves;
    for (const std::int32_t t : m_TrianglesAt[a])
    {
      if (this->Has(t, b))
      {
        leaves.push_back(t);
      }
    }
    return leaves;
  }

  /** How much too sharp a value is: 0 from the limit on, and without bound towards 0, so that the worst place counts
   * most, and of several as bad ones each. */
  static double
  Excess(double value, double limit)
  {
    constexpr double most = 1e6;
    return value >= limit ? 0.0 : value > limit / most ? limit / value - 1.0 : most;
  }

  double
  ExcessOfEdge(PointId a, PointId b) const
  {
    double                          sum = Excess(Distance(this->At(a), this->At(b)), m_Limits.edgeLength);
    const std::vector<std::int32_t> leaves = this->LeavesOf(a, b);
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      for (std::size_t j = i + 1; j < leaves.size(); ++j)
      {
        const PointId c = this->Apex(leaves[i], a, b);
        const PointId d = this->Apex(leaves[j], a, b);
        sum += Excess(DihedralAngle(this->At(a), this->At(b), this->At(c), this->At(d)), m_Limits.dihedralAngle);
      }
    }
    return sum;
  }

  /** Of some triangles and their edges. */
  double
  ExcessOf(const std::vector<std::int32_t> & triangles) const
  {
    double                                   sum = 0.0;
    std::vector<std::pair<PointId, PointId>> edges;
    for (const std::int32_t t : triangles)
    {
      const Triangle & p = m_Mesh.triangles[t];
      sum += Excess(LeastAngle(this->At(p[0]), this->At(p[1]), this->At(p[2])), m_Limits.triangleAngle);
      for (int i = 0; i < 3; ++i)
      {
        edges.push_back(std::minmax(PointId{ p[i] }, PointId{ p[(i + 1) % 3] }));
      }
    }
    SortUnique(edges);
    for (const auto & [a, b] : edges)
    {
      sum += this->ExcessOfEdge(a, b);
    }
    return sum;
  }

  double
  ExcessAt(PointId p) const
  {
    return this->ExcessOf(m_TrianglesAt[p]);
  }

  /** Of the triangles that the point has now. */
  int
  CrossingsAt(const LoosePoint & entry) const
  {
    return this->CrossingsOf(entry, m_TrianglesAt[entry.point]);
  }

  /** Of some triangles that are close to no others than the point's are. */
  int
  CrossingsOf(const LoosePoint & entry, const std::vector<std::int32_t> & triangles) const
  {
    LoosePoint now = entry;
    now.triangles = triangles;
    const auto isGone = [this](std::int32_t t) { return m_IsGone[t]; };
    now.close.erase(std::remove_if(now.close.begin(), now.close.end(), isGone), now.close.end());
    return CountCrossings(m_Mesh, now);
  }

  void
  Erase(PointId p, std::int32_t t)
  {
    auto & at = m_TrianglesAt[p];
    at.erase(std::find(at.begin(), at.end(), t));
  }

  void
  SetTriangle(std::int32_t t, const Triangle & points)
  {
    for (const PointId p : m_Mesh.triangles[t])
    {
      this->Erase(p, t);
    }
    m_Mesh.triangles[t] = points;
    for (const PointId p : points)
    {
      m_TrianglesAt[p].push_back(t);
    }
  }

  std::vector<PointId>
  NeighborsOf(PointId p) const
  {
    std::set<PointId> neighbors;
    for (const std::int32_t t : m_TrianglesAt[p])
    {
      neighbors.insert(m_Mesh.triangles[t].begin(), m_Mesh.triangles[t].end());
    }
    neighbors.erase(p);
    return { neighbors.begin(), neighbors.end() };
  }

  /** Flips the edges at a point for which that is better. */
  void
  Flip(PointId a)
  {
    for (const PointId b : this->NeighborsOf(a))
    {
      const auto at = m_Loose.find(b);
      if (at != m_Loose.end())
      {
        this->FlipEdge(a, b);
      }
    }
  }

  void
  FlipEdge(PointId a, PointId b)
  {
    const std::vector<std::int32_t> leaves = this->LeavesOf(a, b);
    if (leaves.size() != 2 || m_Mesh.wallOfTriangle[leaves[0]] != m_Mesh.wallOfTriangle[leaves[1]])
    {
      return;
    }
    const PointId c = this->Apex(leaves[0], a, b);
    const PointId d = this->Apex(leaves[1], a, b);
    const bool    isChord = m_Mesh.numberOfCells[c] != CellsWithinWall && m_Mesh.numberOfCells[d] != CellsWithinWall;
    if (isChord || c == d || !this->LeavesOf(c, d).empty())
    {
      return;
    }
    const double before = this->ExcessOf(leaves);
    const int    crossings = this->CrossingsAt(*m_Loose.at(a)) + this->CrossingsAt(*m_Loose.at(b));
    if (before == 0.0)
    {
      return;
    }
    const Triangle first = m_Mesh.triangles[leaves[0]];
    const Triangle second = m_Mesh.triangles[leaves[1]];
    // The first triangle runs from a to b or back; b in it makes place for d, and a in the second one for c.
    const auto replaced = [](Triangle t, PointId from, PointId to) {
      std::replace(t.begin(), t.end(), from, to);
      return t;
    };
    this->SetTriangle(leaves[0], replaced(first, b, d));
    this->SetTriangle(leaves[1], replaced(second, a, c));
    const bool isBetter = this->ExcessOf(leaves) < LeastGain * before &&
                          this->CrossingsAt(*m_Loose.at(a)) + this->CrossingsAt(*m_Loose.at(b)) <= crossings;
    if (!isBetter)
    {
      this->SetTriangle(leaves[0], first);
      this->SetTriangle(leaves[1], second);
    }
  }

  bool
  IsWithinWall(PointId a, PointId b) const
  {
    const std::vector<std::int32_t> leaves = this->LeavesOf(a, b);
    return leaves.size() == 2 && m_Mesh.wallOfTriangle[leaves[0]] == m_Mesh.wallOfTriangle[leaves[1]];
  }

  /** Whether a point may go to a neighbour: within its wall, or along its line, with no more than the edge's triangles
   * in the way. */
  bool
  MayCollapse(PointId from, PointId to, const std::vector<std::int32_t> & leaves) const
  {
    const std::uint8_t cells = m_Mesh.numberOfCells[from];
    if (cells == CellsAtCorner || leaves.size() != TrianglesAtEdgeOf(cells) ||
        (cells == CellsOnLine && m_Mesh.numberOfCells[to] == CellsWithinWall))
    {
      return false;
    }
    for (const std::int32_t t : leaves)
    {
      // Two edges become one: where both bound the wall, they would pinch it.
      const PointId apex = this->Apex(t, from, to);
      if (!this->IsWithinWall(from, apex) && !this->IsWithinWall(to, apex))
      {
        return false;
      }
    }
    const std::vector<PointId> ofFrom = this->NeighborsOf(from);
    const std::vector<PointId> ofTo = this->NeighborsOf(to);
    std::vector<PointId>       common;
    std::set_intersection(ofFrom.begin(), ofFrom.end(), ofTo.begin(), ofTo.end(), std::back_inserter(common));
    return common.size() == leaves.size();
  }

  static std::size_t
  TrianglesAtEdgeOf(std::uint8_t cells)
  {
    return cells == CellsWithinWall ? 2 : 3;
  }

  /** Collapses the best of the edges that lead away from a point, where that is better. */
  void
  Collapse(PointId from)
  {
    double                          best = this->ExcessAt(from);
    const std::vector<std::int32_t> old = m_TrianglesAt[from];
    const int                       crossings = this->CrossingsAt(*m_Loose.at(from));
    PointId                         target = -1;
    for (const PointId to : this->NeighborsOf(from))
    {
      const std::vector<std::int32_t> leaves = this->LeavesOf(from, to);
      if (best == 0.0 || !this->MayCollapse(from, to, leaves))
      {
        continue;
      }
      this->Apply(from, to, leaves);
      std::vector<std::int32_t> moved;
      std::copy_if(old.begin(), old.end(), std::back_inserter(moved), [&](std::int32_t t) { return !m_IsGone[t]; });
      const double after = moved.empty() ? best : this->ExcessOf(moved);
      if (after < LeastGain * best && this->CrossingsOf(*m_Loose.at(from), moved) <= crossings)
      {
        best = after;
        target = to;
      }
      this->Revert(from, to, old);
    }
    if (target >= 0)
    {
      this->Apply(from, target, this->LeavesOf(from, target));
    }
  }

  void
  Apply(PointId from, PointId to, const std::vector<std::int32_t> & leaves)
  {
    for (const std::int32_t t : leaves)
    {
      for (const PointId p : m_Mesh.triangles[t])
      {
        this->Erase(p, t);
      }
      m_IsGone[t] = true;
    }
    for (const std::int32_t t : std::vector<std::int32_t>(m_TrianglesAt[from]))
    {
      Triangle moved = m_Mesh.triangles[t];
      std::replace(moved.begin(), moved.end(), from, to);
      this->SetTriangle(t, moved);
    }
  }

  void
  Revert(PointId from, PointId to, const std::vector<std::int32_t> & old)
  {
    for (const std::int32_t t : old)
    {
      if (m_IsGone[t])
      {
        m_IsGone[t] = false;
        for (const PointId p : m_Mesh.triangles[t])
        {
          m_TrianglesAt[p].push_back(t);
        }
      }
      else
      {
        Triangle moved = m_Mesh.triangles[t];
        std::replace(moved.begin(), moved.end(), to, from);
        this->SetTriangle(t, moved);
      }
    }
  }

  /** Moves the point to the best of some places. */
  void
  Move(const LoosePoint & entry)
  {
    if (m_TrianglesAt[entry.point].empty())
    {
      return;
    }
    double best = this->ExcessAt(entry.point);
    if (best == 0.0)
    {
      return;
    }
    const int crossings = this->CrossingsAt(entry);
    Point &   place = m_Mesh.points[entry.point];
    Point     bestPlace = place;
    for (const Point & proposal : this->Propose(entry))
    {
      place = proposal;
      const double excess = this->ExcessAt(entry.point);
      if (excess < LeastGain * best && this->CrossingsAt(entry) <= crossings)
      {
        best = excess;
        bestPlace = proposal;
      }
    }
    place = bestPlace;
  }

  /** Towards the mean of the neighbours, and in all directions. */
  std::vector<Point>
  Propose(const LoosePoint & entry) const
  {
    const Point                old = this->At(entry.point);
    const std::vector<PointId> neighbors = this->NeighborsOf(entry.point);
    const double               share = 1.0 / static_cast<double>(neighbors.size());
    Point                      mean{ { 0.0, 0.0, 0.0 } };
    double                     length = 0.0;
    for (const PointId q : neighbors)
    {
      mean = mean + share * this->At(q);
      length += share * Distance(old, this->At(q));
    }
    std::vector<Point> places{ mean, 0.5 * (old + mean) };
    for (const double step : Steps)
    {
      for (int i = 0; i < 27; ++i)
      {
        const Point direction{ { i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0 } };
        if (i != 13)
        {
          places.push_back(old + (step * length / Norm(direction)) * direction);
        }
      }
    }
    for (Point & p : places)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = std::clamp(p[axis], entry.reach.lower[axis], entry.reach.upper[axis]);
      }
    }
    return places;
  }

  WallMesh & m_Mesh;
  /** With the margin, the edge in the mesh's units. */
  AngleLimits                            m_Limits;
  std::vector<std::vector<std::int32_t>> m_TrianglesAt;
  std::vector<bool>                      m_IsGone;
  std::map<PointId, const LoosePoint *>  m_Loose;
};
/** All points of the triangles that have two of a place's points at least. */
std::set<PointId>
PointsAt(const WallMesh & mesh, const std::vector<SharpPlace> & places)
{
  std::set<std::pair<PointId, PointId>> edges;
  for (const SharpPlace & place : places)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId a = place.points[i];
      const PointId b = place.points[(i + 1) % 3];
      if (a >= 0 && b >= 0)
      {
        edges.insert({ std::min(a, b), std::max(a, b) });
      }
    }
  }
  std::set<PointId> points;
  for (const Triangle & t : mesh.triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const PointId a = t[i];
      const PointId b = t[(i + 1) % 3];
      if (edges.count({ std::min(a, b), std::max(a, b) }) != 0)
      {
        points.insert(t.begin(), t.end());
      }
    }
  }
  return points;
}

/** A mesh that is mended, and what its points were before. */
struct Mended
{
  WallMesh             mesh;
  std::vector<PointId> pointsBefore;
};

/** Mends all places, but none of the points that are to stay. */
Mended
MendAllBut(const std::set<PointId> & staying, const WallMesh & before, const AngleLimits & limits, double median)
{
  Mended mended{ before, std::vector<PointId>(before.points.size()) };
  std::iota(mended.pointsBefore.begin(), mended.pointsBefore.end(), PointId{ 0 });
  std::vector<SharpPlace> places = FindSharpPlaces(mended.mesh, limits);
  for (int round = 0; round < MaximumNumberOfRounds && !places.empty(); ++round)
  {
    std::set<PointId> points = PointsAt(mended.mesh, places);
    for (auto p = points.begin(); p != points.end();)
    {
      p = staying.count(mended.pointsBefore[*p]) != 0 ? points.erase(p) : std::next(p);
    }
    const std::vector<LoosePoint> loose = CollectLoosePoints(mended.mesh, points);
    Mending                       mending(mended.mesh, limits, median);
    mending.MendAt(loose);
    std::vector<PointId> kept = mending.TakeAway();
    std::transform(kept.begin(), kept.end(), kept.begin(), [&mended](PointId p) { return mended.pointsBefore[p]; });
    mended.pointsBefore = std::move(kept);
    places = FindSharpPlaces(mended.mesh, limits);
  }
  return mended;
}

/** The points of triangles that cross, by their numbers before. */
std::set<PointId>
PointsOf(const Mended & mended, const std::vector<TrianglePair> & crossings)
{
  std::set<PointId> points;
  for (const TrianglePair & pair : crossings)
  {
    for (const std::int32_t t : pair)
    {
      for (const PointId p : mended.mesh.triangles[t])
      {
        points.insert(mended.pointsBefore[p]);
      }
    }
  }
  return points;
}

/** Adds some points and their neighbours, one of which may have been joined with them. */
void
AddPointsAround(const WallMesh & mesh, const std::set<PointId> & points, std::set<PointId> & added)
{
  for (const Triangle & t : mesh.triangles)
  {
    if (std::any_of(t.begin(), t.end(), [&points](PointId p) { return points.count(p) != 0; }))
    {
      added.insert(t.begin(), t.end());
    }
  }
}
} // namespace

std::int64_t
MendAngles(WallMesh & mesh, const AngleLimits & limits, const Execution & execution)
{
  // What is near a point is known as it was before a round, so that two changes may meet. Points whose triangles cross
  // in the end stay in the next try.
  constexpr int maximumNumberOfTries = 4;
  const double  median = MedianEdgeLength(mesh);
  if (FindSharpPlaces(mesh, limits).empty())
  {
    return 0;
  }
  const WallMesh    before = mesh;
  const std::size_t crossingsBefore = FindCrossings(before, execution).size();
  std::size_t       least = std::numeric_limits<std::size_t>::max();
  std::set<PointId> staying;
  for (int i = 0; i < maximumNumberOfTries && least > crossingsBefore; ++i)
  {
    Mended                          mended = MendAllBut(staying, before, limits, median);
    const std::vector<TrianglePair> crossings = FindCrossings(mended.mesh, execution);
    AddPointsAround(before, PointsOf(mended, crossings), staying);
    if (crossings.size() < least)
    {
      least = crossings.size();
      mesh = std::move(mended.mesh);
    }
  }
  return static_cast<std::int64_t>(FindSharpPlaces(mesh, limits).size());
}
} // namespace tissue
