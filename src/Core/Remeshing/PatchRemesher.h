/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PatchRemesher_h
#define TissueTessellationCore_PatchRemesher_h

#include "Remeshing/PatchSurface.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace tissue
{
/** \brief Remeshes one wall within its outline, to a wanted number of points within it (WallRemeshing.h).
 *
 * Points are added by splitting the longest edges, and taken away by the collapses that distort least. After each pass
 * of these, edges are flipped and points are moved, where that lowers the sum of TriangleDistortion around them. All
 * points stay on the surface of the first triangles. No collapse, flip or move makes more triangles that are turned
 * over: a triangle counts as turned over if its normal is more than 78 degrees off the mean of the surface's normals at
 * its corners. */
class PatchRemesher
{
public:
  using Vertex = WallPatch::Vertex;
  using HalfEdge = WallPatch::HalfEdge;
  /** Whether two vertices of the outline that are not neighbours on it may be joined. */
  using ChordRule = std::function<bool(Vertex, Vertex)>;

  /** \param patch the wall's triangles, a compact patch.
   * \param mayJoin the rule for chords. */
  PatchRemesher(const WallPatch & patch, ChordRule mayJoin);

  /** Remeshes to a number of points within. Where 16 points or fewer are wanted, one more or one less is taken if that
   * makes the mean TriangleQuality better. Where no collapse is allowed, more points stay. */
  void
  Remesh(int numberOfInteriorVertices);

  /** Gives the patch away, made compact. */
  WallPatch
  TakePatch();

private:
  /** A judgement of some triangles: fewer turned ones are better, and of as many, less distortion. */
  struct Shape
  {
    int    turned = 0;
    double distortion = 0.0;
    double worst = 0.0;

    void
    Add(const Shape & other)
    {
      turned += other.turned;
      distortion += other.distortion;
      worst = std::max(worst, other.worst);
    }
    /** Distortion must fall by a millionth, so that rounding cannot make a change and its reverse both better. */
    bool
    IsBetterThan(const Shape & other) const
    {
      return turned != other.turned ? turned < other.turned : distortion < (1.0 - 1e-6) * other.distortion;
    }
    /** Whether it can still become better than the other by the shapes of so many more triangles: each adds a
     * distortion of 1 at least, but for rounding. */
    bool
    CanBecomeBetterThan(const Shape & other, int more) const
    {
      return other.turned > 0 || (turned == 0 && distortion + (1.0 - 1e-9) * more < other.distortion);
    }
  };
  /** An edge to split or to collapse, the one of least cost first. */
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

  /** A triangulation, with the place of each of its points on the surface. */
  struct State
  {
    WallPatch                       patch;
    std::vector<PatchSurface::Foot> feet;
  };

  Shape
  ShapeOf(Vertex a, Vertex b, Vertex c) const;
  /** The shape of the triangle of a half-edge, which is known from then on until it is forgotten. */
  const Shape &
  KnownShape(HalfEdge h);
  /** Judges the triangles at a vertex. */
  Shape
  ShapeAround(Vertex v);
  void
  ForgetShapesAround(Vertex v);
  void
  ForgetAllShapes();
  /** Whether an edge may join two vertices; only chords, between two vertices of the outline, can be forbidden. */
  bool
  MayJoin(Vertex a, Vertex b) const;
  /** Marks triangles as changed in this pass. Where one of them is marked already, returns false and marks none. */
  bool
  Claim(const std::vector<HalfEdge> & halfEdges);

  void
  RemeshTo(int numberOfInteriorVertices);

  /** Makes one pass of splits, `most` of them at most, and returns their number. */
  int
  SplitLongest(int most);
  bool
  MayCollapse(HalfEdge h) const;
  /** Returns the legal collapse of a vertex within that adds least distortion; its edge is None where there is none. */
  Candidate
  BestCollapse(Vertex v);
  /** Makes one pass of collapses, `most` of them at most, and returns their number. */
  int
  CollapseBest(int most);
  bool
  FlipIfBetter(HalfEdge h);
  void
  FlipEdges();
  void
  MoveVertices();
  /** Moves a vertex to the surface's point near a target, if that makes the triangles at it better than this shape. */
  bool
  MoveIfBetter(Vertex v, const Point & target, Shape & shape);
  void
  MoveVertex(Vertex v);

  WallPatch                       m_Patch;
  PatchSurface                    m_Surface;
  ChordRule                       m_MayJoin;
  std::vector<PatchSurface::Foot> m_Feet;
  std::vector<char>               m_Claimed;
  /** Of each triangle; the distortion of one that is not known is 0. */
  std::vector<Shape> m_Shapes;
};
} // namespace tissue

#endif
