/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/PatchRemesher.h"

#include "Mesh/WallPatch.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <algorithm>
#include <limits>

namespace tissue
{
namespace
{
/** How often all edges are tried for a flip, at most, before points move. More rounds take more time and find less to
 * do. */
constexpr int FlipRounds = 3;
/** The largest number of points within a wall at which one more and one less are tried as well. This takes three times
 * as long, and the more points there are, the less one of them matters. */
constexpr int MostVaried = 16;
/** The number of steps that are tried downhill: a quarter of the length of an edge at the point, then three times half
 * of the step before. */
constexpr int LineSearchSteps = 4;
/** The distortion that a degenerate triangle counts for, in place of an infinite one, that of a quality of 1e-6: sums
 * stay finite, so that of two shapes with such triangles the better one is known. */
constexpr double MostDistortion = 1e12;
/** The cosine of the angle between the normals of a triangle and of the surface, 78 degrees, from which on the triangle
 * counts as turned over: it leaves room for bent walls, but none for triangles that stand across the surface. */
constexpr double LeastCosine = 0.2;
/** The largest distortion that a collapse may leave, unless one of the triangles it changes had more: that of a quality
 * of 0.5. Flips and moves mend what is not worse; with a stricter limit more points would stay than wanted. */
constexpr double CollapseDistortion = 4.0;
} // namespace

PatchRemesher::PatchRemesher(const WallPatch & patch, ChordRule mayJoin)
  : m_Patch(patch)
  , m_Surface(patch)
  , m_MayJoin(std::move(mayJoin))
{
  for (Vertex v = 0; v < m_Patch.EndOfVertices(); ++v)
  {
    m_Feet.push_back(m_Surface.FootAt(v));
  }
}

PatchRemesher::Shape
PatchRemesher::ShapeOf(Vertex a, Vertex b, Vertex c) const
{
  // The surface's normal is the mean of those at the corners' feet. The cosine of its angle to the triangle's normal is
  // compared by squares, which saves the roots.
  const Point & p = m_Patch.PointAt(a);
  const Point & q = m_Patch.PointAt(b);
  const Point & r = m_Patch.PointAt(c);
  const Point   cross = Cross(q - p, r - p);
  const Point   up = m_Feet[a].normal + m_Feet[b].normal + m_Feet[c].normal;
  const double  along = Dot(cross, up);
  const bool    upright = along > 0.0 && along * along > LeastCosine * LeastCosine * Dot(cross, cross) * Dot(up, up);
  const double  distortion = std::min(MostDistortion, TriangleDistortion(p, q, r));
  return { upright ? 0 : 1, distortion, distortion };
}

const PatchRemesher::Shape &
PatchRemesher::KnownShape(HalfEdge h)
{
  Shape & shape = m_Shapes[h / 3];
  if (shape.distortion == 0.0)
  {
    shape = this->ShapeOf(m_Patch.From(h), m_Patch.To(h), m_Patch.Opposite(h));
  }
  return shape;
}

PatchRemesher::Shape
PatchRemesher::ShapeAround(Vertex v)
{
  Shape shape;
  m_Patch.ForEachAround(v, [&](HalfEdge h) { shape.Add(this->KnownShape(h)); });
  return shape;
}

void
PatchRemesher::ForgetShapesAround(Vertex v)
{
  m_Patch.ForEachAround(v, [&](HalfEdge h) { m_Shapes[h / 3] = Shape(); });
}

void
PatchRemesher::ForgetAllShapes()
{
  m_Shapes.assign(m_Patch.EndOfHalfEdges() / 3, Shape());
}

bool
PatchRemesher::MayJoin(Vertex a, Vertex b) const
{
  return a >= m_Patch.OutlineSize() || b >= m_Patch.OutlineSize() || m_MayJoin(a, b);
}

bool
PatchRemesher::Claim(const std::vector<HalfEdge> & halfEdges)
{
  const auto end = static_cast<HalfEdge>(3 * m_Claimed.size());
  for (const HalfEdge h : halfEdges)
  {
    // Triangles that this pass has made are beyond the end, and are not to be changed again in it.
    if (h >= end || m_Claimed[h / 3])
    {
      return false;
    }
  }
  for (const HalfEdge h : halfEdges)
  {
    m_Claimed[h / 3] = 1;
  }
  return true;
}

int
PatchRemesher::SplitLongest(int most)
{
  // One pass splits at their middles the edges within the wall that are nearly as long as the longest, longest first,
  // none in a triangle that the pass has changed. The middle is put on the surface.
  std::vector<Candidate> candidates;
  for (HalfEdge h = 0; h < m_Patch.EndOfHalfEdges(); ++h)
  {
    if (m_Patch.IsAlive(h) && m_Patch.Twin(h) > h)
    {
      candidates.push_back({ -Distance(m_Patch.PointAt(m_Patch.From(h)), m_Patch.PointAt(m_Patch.To(h))), h });
    }
  }
  std::sort(candidates.begin(), candidates.end());
  m_Claimed.assign(m_Patch.EndOfHalfEdges() / 3, 0);
  // A share of the longest edge's length. A smaller one takes fewer passes, but splits edges that flips and moves would
  // have shortened.
  constexpr double longEnough = 0.7;
  int              count = 0;
  for (const Candidate & candidate : candidates)
  {
    const HalfEdge h = candidate.edge;
    if (count == most || candidate.cost > longEnough * candidates.front().cost)
    {
      break;
    }
    if (this->Claim({ h, m_Patch.Twin(h) }))
    {
      const Vertex from = m_Patch.From(h);
      const Point  middle = 0.5 * (m_Patch.PointAt(from) + m_Patch.PointAt(m_Patch.To(h)));
      const int    start = m_Feet[from >= m_Patch.OutlineSize() ? from : m_Patch.To(h)].triangle;
      m_Feet.push_back(m_Surface.FindFoot(middle, start));
      m_Patch.Split(h, m_Feet.back().point);
      ++count;
    }
  }
  return count;
}

bool
PatchRemesher::MayCollapse(HalfEdge h) const
{
  const Vertex target = m_Patch.To(h);
  bool         legal = m_Patch.CanCollapse(h);
  m_Patch.ForEachAround(m_Patch.From(h), [&](HalfEdge around) {
    const Vertex v = m_Patch.To(around);
    legal = legal && (v == target || this->MayJoin(target, v) || m_Patch.AreJoined(target, v));
  });
  return legal;
}

PatchRemesher::Candidate
PatchRemesher::BestCollapse(Vertex v)
{
  const Shape before = this->ShapeAround(v);
  Candidate   best{ std::numeric_limits<double>::infinity(), WallPatch::None };
  m_Patch.ForEachAround(v, [&](HalfEdge h) {
    const Vertex target = m_Patch.To(h);
    Shape        after;
    m_Patch.ForEachAround(v, [&](HalfEdge around) {
      const Vertex a = m_Patch.To(around);
      const Vertex b = m_Patch.Opposite(around);
      if (a != target && b != target)
      {
        after.Add(this->ShapeOf(target, a, b));
      }
    });
    const Candidate candidate{ after.distortion - before.distortion, h };
    if (candidate < best && after.turned <= before.turned &&
        after.worst <= std::max(before.worst, CollapseDistortion) && this->MayCollapse(h))
    {
      best = candidate;
    }
  });
  return best;
}

int
PatchRemesher::CollapseBest(int most)
{
  // One pass collapses the points within the wall that add least distortion, at most the best quarter of them and none
  // in a triangle that the pass has changed: flips and moves before the next pass make the others' costs new.
  std::vector<Candidate> candidates;
  for (Vertex v = m_Patch.OutlineSize(); v < m_Patch.EndOfVertices(); ++v)
  {
    const Candidate best = m_Patch.HasVertex(v) ? this->BestCollapse(v) : Candidate{ 0.0, WallPatch::None };
    if (best.edge != WallPatch::None)
    {
      candidates.push_back(best);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  m_Claimed.assign(m_Patch.EndOfHalfEdges() / 3, 0);
  int count = 0;
  for (std::size_t i = 0; i < candidates.size() && count < most && i <= candidates.size() / 4; ++i)
  {
    const HalfEdge h = candidates[i].edge;
    if (!m_Patch.IsAlive(h))
    {
      continue;
    }
    std::vector<HalfEdge> changed;
    for (const Vertex v : { m_Patch.From(h), m_Patch.To(h) })
    {
      m_Patch.ForEachAround(v, [&](HalfEdge around) { changed.push_back(around); });
    }
    if (this->Claim(changed))
    {
      m_Patch.Collapse(h);
      ++count;
    }
  }
  return count;
}

bool
PatchRemesher::FlipIfBetter(HalfEdge h)
{
  // The edge (a, b) between the triangles with c and d becomes (c, d).
  const Vertex a = m_Patch.From(h);
  const Vertex b = m_Patch.To(h);
  const Vertex c = m_Patch.Opposite(h);
  const Vertex d = m_Patch.Opposite(m_Patch.Twin(h));
  Shape        before = this->KnownShape(h);
  before.Add(this->KnownShape(m_Patch.Twin(h)));
  Shape after = this->ShapeOf(c, d, b);
  if (!after.CanBecomeBetterThan(before, 1))
  {
    return false;
  }
  after.Add(this->ShapeOf(d, c, a));
  if (!after.IsBetterThan(before) || m_Patch.AreJoined(c, d) || !this->MayJoin(c, d))
  {
    return false;
  }
  m_Shapes[h / 3] = Shape();
  m_Shapes[m_Patch.Twin(h) / 3] = Shape();
  m_Patch.Flip(h);
  return true;
}

void
PatchRemesher::FlipEdges()
{
  bool flipped = true;
  for (int round = 0; round < FlipRounds && flipped; ++round)
  {
    flipped = false;
    for (HalfEdge h = 0; h < m_Patch.EndOfHalfEdges(); ++h)
    {
      if (m_Patch.IsAlive(h) && m_Patch.Twin(h) > h)
      {
        flipped = this->FlipIfBetter(h) || flipped;
      }
    }
  }
}

bool
PatchRemesher::MoveIfBetter(Vertex v, const Point & target, Shape & shape)
{
  const PatchSurface::Foot old = m_Feet[v];
  m_Feet[v] = m_Surface.FindFoot(target, old.triangle);
  m_Patch.SetPoint(v, m_Feet[v].point);
  int   more = 0;
  Shape moved;
  bool  isPromising = true;
  m_Patch.ForEachAround(v, [&](HalfEdge) { ++more; });
  m_Patch.ForEachAround(v, [&](HalfEdge h) {
    if (isPromising)
    {
      moved.Add(this->ShapeOf(v, m_Patch.To(h), m_Patch.Opposite(h)));
      isPromising = moved.CanBecomeBetterThan(shape, --more);
    }
  });
  if (isPromising && moved.IsBetterThan(shape))
  {
    shape = moved;
    this->ForgetShapesAround(v);
    return true;
  }
  m_Feet[v] = old;
  m_Patch.SetPoint(v, old.point);
  return false;
}

void
PatchRemesher::MoveVertex(Vertex v)
{
  // The mean of the neighbours is tried first. Where that is no better, steps follow against the gradient of the sum of
  // distortions, without its part along the surface's normal.
  Shape       shape = this->ShapeAround(v);
  const Point at = m_Patch.PointAt(v);
  Point       sum{ { 0.0, 0.0, 0.0 } };
  Point       gradient{ { 0.0, 0.0, 0.0 } };
  int         count = 0;
  m_Patch.ForEachAround(v, [&](HalfEdge h) {
    const Point & a = m_Patch.PointAt(m_Patch.To(h));
    sum = sum + a;
    gradient = gradient + TriangleDistortionGradient(at, a, m_Patch.PointAt(m_Patch.Opposite(h)));
    ++count;
  });
  const Point mean = (1.0 / count) * sum;
  if (this->MoveIfBetter(v, mean, shape))
  {
    return;
  }
  const Point & normal = m_Feet[v].normal;
  const Point   downhill = Normalized(Dot(gradient, normal) * normal - gradient);
  double        step = 0.25 * Distance(at, m_Patch.PointAt(m_Patch.To(m_Patch.Leaving(v))));
  for (int i = 0; i < LineSearchSteps; ++i, step *= 0.5)
  {
    if (this->MoveIfBetter(v, at + step * downhill, shape))
    {
      return;
    }
  }
}

void
PatchRemesher::MoveVertices()
{
  for (Vertex v = m_Patch.OutlineSize(); v < m_Patch.EndOfVertices(); ++v)
  {
    if (m_Patch.HasVertex(v))
    {
      this->MoveVertex(v);
    }
  }
}

void
PatchRemesher::RemeshTo(int numberOfInteriorVertices)
{
  // Passes add or take away points until their number is right or none can go any more; flips and moves follow each,
  // and once more at the end.
  this->ForgetAllShapes();
  for (int changed = 1; changed > 0;)
  {
    const int missing = numberOfInteriorVertices - m_Patch.NumberOfInteriorVertices();
    changed = missing > 0 ? this->SplitLongest(missing) : missing < 0 ? this->CollapseBest(-missing) : 0;
    this->ForgetAllShapes();
    this->FlipEdges();
    this->MoveVertices();
  }
  this->FlipEdges();
  this->MoveVertices();
}

void
PatchRemesher::Remesh(int numberOfInteriorVertices)
{
  this->RemeshTo(numberOfInteriorVertices);
  if (numberOfInteriorVertices > MostVaried)
  {
    return;
  }
  // With few points within, it depends on the outline how many of them fit best.
  const State start{ m_Patch, m_Feet };
  State       best = start;
  double      bestQuality = MeanQuality(m_Patch);
  for (const int change : { 1, -1 })
  {
    m_Patch = start.patch;
    m_Feet = start.feet;
    this->RemeshTo(numberOfInteriorVertices + change);
    const double quality = MeanQuality(m_Patch);
    if (quality > bestQuality)
    {
      bestQuality = quality;
      best = { m_Patch, m_Feet };
    }
  }
  m_Patch = std::move(best.patch);
  m_Feet = std::move(best.feet);
}

WallPatch
PatchRemesher::TakePatch()
{
  m_Patch.Compact();
  return std::move(m_Patch);
}
} // namespace tissue
