/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PatchSurface_h
#define TissueTessellationCore_PatchSurface_h

#include "Mesh/WallPatch.h"

#include <vector>

namespace tissue
{
/** \brief A wall's triangles as the surface on which the points of another triangulation of it lie. */
class PatchSurface
{
public:
  /** A point of the surface. */
  struct Foot
  {
    Point point;
    /** The unit normal, interpolated from those at the triangle's corners. */
    Point        normal;
    std::int32_t triangle;
  };

  /** \param patch the wall's triangles, a compact patch, which is copied. */
  explicit PatchSurface(const WallPatch & patch);

  /** Returns a vertex of the wall as a point of the surface. */
  Foot
  FootAt(WallPatch::Vertex v) const;

  /** Returns the nearest point of the surface that a walk from a triangle finds. The walk goes over edges and corners
   * as long as the distance shrinks, so that it does not see the wall's other sheets where the wall is folded. */
  Foot
  FindFoot(const Point & point, std::int32_t start) const;

private:
  struct Nearest
  {
    std::array<double, 3> weights;
    Point                 point;
    double                squaredDistance;
  };

  Nearest
  FindNearest(std::int32_t triangle, const Point & point) const;

  WallPatch          m_Patch;
  std::vector<Point> m_Normals;
};
} // namespace tissue

#endif
