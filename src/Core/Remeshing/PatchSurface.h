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
    /** Of unit length, interpolated from those at the triangle's corners. */
    Point        normal;
    std::int32_t triangle;
  };

  /** \param patch a compact one. */
  explicit PatchSurface(const WallPatch & patch);

  Foot
  FootAt(WallPatch::Vertex v) const;

  /** The nearest point that a walk downhill finds from a triangle near it: over edges and corners, for as long as the
   * distance shrinks. The wall's other sheets, where it is folded, are not seen. */
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
