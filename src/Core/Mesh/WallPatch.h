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
 * Half-edge 3 t + k runs from corner k of triangle t to the next one. The vertices of the outline come first, and stay;
 * the others can be made and removed. No number is used again before Compact(). */
class WallPatch
{
public:
  using HalfEdge = std::int32_t;
  using Vertex = std::int32_t;

  /** What stands for no half-edge and for no vertex: numbers of both are 0 or more. */
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
  /** The half-edge of the same edge in the other direction; None on the outline. */
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

  /** A half-edge that leaves the vertex. For a vertex of the outline it is the one along the outline. */
  HalfEdge
  Leaving(Vertex v) const
  {
    return m_Leaving[v];
  }
  /** The next half-edge, counterclockwise, that leaves the same vertex. It is None after the last one of a vertex of
   * the outline. */
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

  /** Puts a new vertex on the edge, which must have a twin, and makes four triangles of two. */
  Vertex
  Split(HalfEdge h, const Point & point);

  /** Replaces the edge by the other diagonal of its two triangles, whose ends must not be joined already. */
  void
  Flip(HalfEdge h);

  /** Tells whether Collapse(h) keeps a disk of proper triangles: From(h) must not be a vertex of the outline, nor have
   * another neighbour in common with To(h) than the two corners opposite to the edge. */
  bool
  CanCollapse(HalfEdge h) const;

  /** Moves From(h) to To(h), where it vanishes together with the two triangles at the edge. */
  void
  Collapse(HalfEdge h);

  /** Numbers vertices and triangles anew, without gaps and in their order. */
  void
  Compact();

  /** The corners of all triangles. The patch must be compact. */
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
