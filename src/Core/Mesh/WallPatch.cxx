/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Mesh/WallPatch.h"

#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <algorithm>

namespace tissue
{
WallPatch::WallPatch(std::vector<Point> points, const std::vector<std::array<Vertex, 3>> & triangles,
                     Vertex outlineSize)
  : m_Points(std::move(points))
  , m_OutlineSize(outlineSize)
  , m_NumberOfInteriorVertices(static_cast<int>(m_Points.size()) - outlineSize)
{
  m_From.reserve(3 * triangles.size());
  for (const auto & t : triangles)
  {
    m_From.insert(m_From.end(), t.begin(), t.end());
  }
  this->FindTwins();
}

void
WallPatch::FindTwins()
{
  // Sorted by their edges, the two half-edges of an edge are neighbours. A half-edge without a twin is on the outline,
  // and is the one by which its vertex is left.
  const auto edgeOf = [this](HalfEdge h) { return std::make_pair(std::min(From(h), To(h)), std::max(From(h), To(h))); };
  m_Twin.assign(m_From.size(), None);
  m_Leaving.assign(m_Points.size(), None);
  std::vector<HalfEdge> sorted(m_From.size());
  for (HalfEdge h = 0; h < this->EndOfHalfEdges(); ++h)
  {
    sorted[h] = h;
    m_Leaving[From(h)] = h;
  }
  std::sort(sorted.begin(), sorted.end(), [&](HalfEdge a, HalfEdge b) { return edgeOf(a) < edgeOf(b); });
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    if (i + 1 < sorted.size() && From(sorted[i]) == To(sorted[i + 1]) && To(sorted[i]) == From(sorted[i + 1]))
    {
      this->Pair(sorted[i], sorted[i + 1]);
      ++i;
    }
  }
  for (HalfEdge h = 0; h < this->EndOfHalfEdges(); ++h)
  {
    if (m_Twin[h] == None)
    {
      m_Leaving[From(h)] = h;
    }
  }
}

void
WallPatch::Pair(HalfEdge a, HalfEdge b)
{
  if (a != None)
  {
    m_Twin[a] = b;
  }
  if (b != None)
  {
    m_Twin[b] = a;
  }
}

void
WallPatch::SetTriangle(HalfEdge first, Vertex a, Vertex b, Vertex c)
{
  m_From[first] = a;
  m_From[first + 1] = b;
  m_From[first + 2] = c;
}

bool
WallPatch::AreJoined(Vertex a, Vertex b) const
{
  bool joined = false;
  this->ForEachAround(a, [&](HalfEdge h) { joined = joined || To(h) == b || Opposite(h) == b; });
  return joined;
}

WallPatch::Vertex
WallPatch::Split(HalfEdge h, const Point & point)
{
  // The triangles (a, b, c) and (b, a, d) become (a, m, c), (m, b, c), (b, m, d), (m, a, d). The first and the third
  // keep their place; the others are new.
  const HalfEdge g = m_Twin[h];
  const Vertex   b = To(h);
  const Vertex   a = From(h);
  const Vertex   c = Opposite(h);
  const Vertex   d = Opposite(g);
  const HalfEdge hNext = m_Twin[Next(h)];
  const HalfEdge gNext = m_Twin[Next(g)];
  const auto     m = static_cast<Vertex>(m_Points.size());
  const HalfEdge bc = this->EndOfHalfEdges();
  const HalfEdge ad = bc + 3;
  m_Points.push_back(point);
  ++m_NumberOfInteriorVertices;
  m_From.resize(m_From.size() + 6);
  m_Twin.resize(m_Twin.size() + 6, None);
  this->SetTriangle(bc, m, b, c); // half-edges m b, b c, c m
  this->SetTriangle(ad, m, a, d);
  m_From[Next(h)] = m; // h is a m, its next m c
  m_From[Next(g)] = m; // g is b m, its next m d
  m_Leaving.push_back(bc);
  const auto moveLeaving = [this](Vertex v, HalfEdge old, HalfEdge now) {
    m_Leaving[v] = m_Leaving[v] == old ? now : m_Leaving[v];
  };
  moveLeaving(b, Next(h), bc + 1);
  moveLeaving(a, Next(g), ad + 1);
  this->Pair(bc + 1, hNext);
  this->Pair(ad + 1, gNext);
  this->Pair(Next(h), bc + 2);
  this->Pair(Next(g), ad + 2);
  this->Pair(h, ad);
  this->Pair(g, bc);
  return m;
}

void
WallPatch::Flip(HalfEdge h)
{
  // The triangles (a, b, c) and (b, a, d) become (c, d, b) and (d, c, a), in the same places.
  const HalfEdge                g = m_Twin[h];
  const Vertex                  a = From(h);
  const Vertex                  b = To(h);
  const Vertex                  c = Opposite(h);
  const Vertex                  d = Opposite(g);
  const std::array<HalfEdge, 4> old{ { Next(h), Previous(h), Next(g), Previous(g) } }; // b c, c a, a d, d b
  const std::array<HalfEdge, 4> twins{ { m_Twin[old[0]], m_Twin[old[1]], m_Twin[old[2]], m_Twin[old[3]] } };
  const HalfEdge                first = h - h % 3;
  const HalfEdge                second = g - g % 3;
  // A leaving half-edge of the outline has no twin, so it is one of the four and goes where its edge goes.
  const std::array<HalfEdge, 4> now{ { first + 2, second + 1, second + 2, first + 1 } };
  const std::array<Vertex, 4>   from{ { b, c, a, d } };
  this->SetTriangle(first, c, d, b);
  this->SetTriangle(second, d, c, a);
  this->Pair(first, second);
  for (int i = 0; i < 4; ++i)
  {
    m_Twin[now[i]] = None;
    this->Pair(now[i], twins[i]);
  }
  for (int i = 0; i < 4; ++i)
  {
    const HalfEdge leaving = m_Leaving[from[i]];
    const bool     ofTheTwo = leaving / 3 == first / 3 || leaving / 3 == second / 3;
    // The leaving half-edge of a vertex of the outline stays where it is in another triangle.
    if (twins[i] == None || (ofTheTwo && from[i] >= m_OutlineSize))
    {
      m_Leaving[from[i]] = now[i];
    }
  }
}

bool
WallPatch::CanCollapse(HalfEdge h) const
{
  const Vertex u = From(h);
  const Vertex w = To(h);
  if (u < m_OutlineSize)
  {
    return false;
  }
  int common = 0;
  this->ForEachAround(u, [&](HalfEdge around) { common += this->AreJoined(w, To(around)) ? 1 : 0; });
  return common == 2;
}

void
WallPatch::Collapse(HalfEdge h)
{
  const HalfEdge g = m_Twin[h];
  const Vertex   u = From(h);
  const Vertex   w = To(h);
  const Vertex   c = Opposite(h);
  const Vertex   d = Opposite(g);
  this->ForEachAround(u, [this, w](HalfEdge around) { m_From[around] = w; });
  // Each of the two triangles is closed like a book: its two other edges become one.
  const HalfEdge toC = m_Twin[Previous(h)]; // was u c
  const HalfEdge fromD = m_Twin[Next(g)];   // was d u
  this->Pair(toC, m_Twin[Next(h)]);
  this->Pair(fromD, m_Twin[Previous(g)]);
  const auto moveLeaving = [&](Vertex v, HalfEdge now) {
    const HalfEdge old = m_Leaving[v];
    m_Leaving[v] = old / 3 == h / 3 || old / 3 == g / 3 ? now : old;
  };
  moveLeaving(c, Next(toC));
  moveLeaving(d, fromD);
  moveLeaving(w, toC);
  for (const HalfEdge side : { h, g })
  {
    const HalfEdge first = side - side % 3;
    this->SetTriangle(first, None, None, None);
  }
  m_Leaving[u] = None;
  --m_NumberOfInteriorVertices;
}

void
WallPatch::Compact()
{
  std::vector<Vertex> numberOf(m_Points.size(), None);
  Vertex              count = 0;
  for (Vertex v = 0; v < this->EndOfVertices(); ++v)
  {
    if (this->HasVertex(v))
    {
      m_Points[count] = m_Points[v];
      numberOf[v] = count++;
    }
  }
  m_Points.resize(count);
  std::size_t end = 0;
  for (HalfEdge h = 0; h < this->EndOfHalfEdges(); ++h)
  {
    if (IsAlive(h))
    {
      m_From[end++] = numberOf[m_From[h]];
    }
  }
  m_From.resize(end);
  this->FindTwins();
}

std::vector<std::array<WallPatch::Vertex, 3>>
WallPatch::Triangles() const
{
  std::vector<std::array<Vertex, 3>> triangles;
  triangles.reserve(m_From.size() / 3);
  for (std::size_t h = 0; h < m_From.size(); h += 3)
  {
    triangles.push_back({ { m_From[h], m_From[h + 1], m_From[h + 2] } });
  }
  return triangles;
}

namespace
{
/** Calls the function with the corners of each triangle. */
template <typename TFunction>
void
ForEachTriangle(const WallPatch & patch, TFunction function)
{
  for (WallPatch::HalfEdge h = 0; h < patch.EndOfHalfEdges(); h += 3)
  {
    if (patch.IsAlive(h))
    {
      function(patch.PointAt(patch.From(h)), patch.PointAt(patch.To(h)), patch.PointAt(patch.Opposite(h)));
    }
  }
}
} // namespace

double
AreaOf(const WallPatch & patch)
{
  double area = 0.0;
  ForEachTriangle(patch, [&](const Point & a, const Point & b, const Point & c) { area += TriangleArea(a, b, c); });
  return area;
}

double
MeanQuality(const WallPatch & patch)
{
  double sum = 0.0;
  int    count = 0;
  ForEachTriangle(patch, [&](const Point & a, const Point & b, const Point & c) {
    sum += TriangleQuality(a, b, c);
    ++count;
  });
  return count > 0 ? sum / count : 0.0;
}
} // namespace tissue
