/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallPatch_h
#define TissueTessellationCore_WallPatch_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The triangles of one wall as half-edges, to be changed in place: a disk before and after every operation.
 *
 * Half-edge 3 t + k runs from corner k of triangle t to the next one. Vertices of the outline come first, and stay;
 * the others can be made and removed. Numbers are never used again until Compact(). */
class WallPatch
{
public:
  using HalfEdge = std::int32_t;
  using Vertex = std::int32_t;

  static constexpr HalfEdge None = -1;

  WallPatch(std::vector<Point> points, const std::vector<std::array<Vertex, 3>> & triangles, Vertex outlineSize);

  static HalfEdge
  Next(HalfEdge h)
  {
    return h % 3 == 2 ? h - 2 : h + 1;
  }
  static HalfEdge
  Previous(HalfEdge h)
  {
    return h % 3 == 0 ? h + 2 : h - 1;
  }
  Vertex
  From(HalfEdge h) const
  {
    return m_From[h];
  }
  Vertex
  To(HalfEdge h) const
  {
    return m_From[Next(h)];
  }
  /** The corner of the triangle of `h` that is not on it. */
  Vertex
  Opposite(HalfEdge h) const
  {
    return m_From[Previous(h)];
  }
  /** The half-edge in the other direction, None on the outline. */
  HalfEdge
  Twin(HalfEdge h) const
  {
    return m_Twin[h];
  }
  bool
  IsAlive(HalfEdge h) const
  {
    return m_From[h] != None;
  }
  HalfEdge
  EndOfHalfEdges() const
  {
    return static_cast<HalfEdge>(m_From.size());
  }
  Vertex
  EndOfVertices() const
  {
    return static_cast<Vertex>(m_Points.size());
  }
  Vertex
  OutlineSize() const
  {
    return m_OutlineSize;
  }
  bool
  HasVertex(Vertex v) const
  {
    return m_Leaving[v] != None;
  }
  int
  NumberOfInteriorVertices() const
  {
    return m_NumberOfInteriorVertices;
  }
  const Point &
  PointAt(Vertex v) const
  {
    return m_Points[v];
  }
  void
  SetPoint(Vertex v, const Point & point)
  {
    m_Points[v] = point;
  }

  /** A half-edge that leaves the vertex; on the outline the one along it. */
  HalfEdge
  Leaving(Vertex v) const
  {
    return m_Leaving[v];
  }
  /** The next one that leaves the same vertex, counterclockwise: None after the last of a vertex of the outline. */
  HalfEdge
  NextAround(HalfEdge h) const
  {
    return m_Twin[Previous(h)];
  }
  /** Calls the function with each half-edge that leaves the vertex, one for each of its triangles. */
  template <typename TFunction>
  void
  ForEachAround(Vertex v, TFunction function) const
  {
    const HalfEdge first = m_Leaving[v];
    HalfEdge       h = first;
    do
    {
      function(h);
      h = this->NextAround(h);
    } while (h != first && h != None);
  }
  bool
  AreJoined(Vertex a, Vertex b) const;

  /** A new vertex on the edge, which has a twin: four triangles for two. */
  Vertex
  Split(HalfEdge h, const Point & point);

  /** The other diagonal of the two triangles at the edge. The four corners may not be joined otherwise. */
  void
  Flip(HalfEdge h);

  /** Whether Collapse(h) keeps a disk of proper triangles: From(h) is no vertex of the outline, and has no other
   * neighbour in common with To(h) than the corners opposite to the edge. */
  bool
  CanCollapse(HalfEdge h) const;

  /** Moves From(h) to To(h), where it vanishes with the two triangles at the edge. */
  void
  Collapse(HalfEdge h);

  /** Numbers vertices and triangles anew, without gaps and in their order. */
  void
  Compact();

  /** Of a compact patch. */
  std::vector<std::array<Vertex, 3>>
  Triangles() const;

private:
  void
  Pair(HalfEdge a, HalfEdge b);
  void
  SetTriangle(HalfEdge first, Vertex a, Vertex b, Vertex c);
  void
  FindTwins();

  std::vector<Point>    m_Points;
  std::vector<Vertex>   m_From;
  std::vector<HalfEdge> m_Twin;
  std::vector<HalfEdge> m_Leaving;
  Vertex                m_OutlineSize;
  int                   m_NumberOfInteriorVertices;
};

/** The sum of the areas of a patch's triangles. */
double
AreaOf(const WallPatch & patch);

/** The mean TriangleQuality of a patch's triangles; 0 without any. */
double
MeanQuality(const WallPatch & patch);
} // namespace tissue

#endif
