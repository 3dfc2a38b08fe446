/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PatchRemesher_h
#define TissueTessellationCore_PatchRemesher_h

#include "Remeshing/PatchSurface.h"

#include <functional>
#include <vector>

namespace tissue
{
/** \brief Remeshes one wall within its outline, to a wanted number of points within (WallRemeshing.h).
 *
 * Points are added by splitting the longest edges and taken away by the collapses that distort least; then edges are
 * flipped and points moved on the surface of the first triangles, for as long as the sum of TriangleDistortion falls.
 * No step turns a triangle over, as seen along the surface's normals at its corners: at most by 78 degrees. */
class PatchRemesher
{
public:
  using Vertex = WallPatch::Vertex;
  using HalfEdge = WallPatch::HalfEdge;
  /** Whether two vertices of the outline that are not neighbours on it may be joined. */
  using ChordRule = std::function<bool(Vertex, Vertex)>;

  /** \param patch a compact one. */
  PatchRemesher(const WallPatch & patch, ChordRule mayJoin);

  /** Up to 16 points within, one more or one less is taken where that makes the mean TriangleQuality better. More stay
   * where no collapse is allowed. */
  void
  Remesh(int numberOfInteriorVertices);

  WallPatch
  TakePatch();

private:
  /** Judges triangles; fewer turned ones are better, then less distortion. */
  struct Shape
  {
    int    turned = 0;
    double distortion = 0.0;
    double worst = 0.0;

    bool
    IsBetterThan(const Shape & other) const
    {
      return turned != other.turned ? turned < other.turned : distortion < (1.0 - 1e-6) * other.distortion;
    }
  };
  struct Candidate
  {
    double   cost;
    HalfEdge edge;
    bool
    operator<(const Candidate & other) const
    {
      return cost != other.cost ? cost < other.cost : edge < other.edge;
    }
  };

  struct State
  {
    WallPatch                       patch;
    std::vector<PatchSurface::Foot> feet;
  };

  void
  AddTriangle(Shape & shape, Vertex a, Vertex b, Vertex c) const;
  Shape
  ShapeAround(Vertex v) const;
  bool
  MayJoin(Vertex a, Vertex b) const;
  /** Marks triangles as changed in this pass; false, and none is marked, where one of them is already. */
  bool
  Claim(const std::vector<HalfEdge> & halfEdges);

  void
  RemeshTo(int numberOfInteriorVertices);

  int
  SplitLongest(int most);
  bool
  MayCollapse(HalfEdge h) const;
  Candidate
  BestCollapse(Vertex v) const;
  int
  CollapseBest(int most);
  bool
  FlipIfBetter(HalfEdge h);
  void
  FlipEdges();
  void
  MoveVertices();
  bool
  MoveIfBetter(Vertex v, const Point & target, Shape & shape);
  void
  MoveVertex(Vertex v);

  WallPatch                       m_Patch;
  PatchSurface                    m_Surface;
  ChordRule                       m_MayJoin;
  std::vector<PatchSurface::Foot> m_Feet;
  std::vector<char>               m_Claimed;
};
} // namespace tissue

#endif
