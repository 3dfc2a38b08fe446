/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_OuterTriangles_h
#define TissueTessellationCore_OuterTriangles_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <functional>
#include <vector>

namespace tissue
{
/** Where a triangle is. */
enum class TrianglePlace : unsigned char
{
  /** Between two cells, or at a void that the tissue encloses. */
  Within,
  /** On the tissue's surface. */
  Surface,
  /** On its surface where a plane cuts it. */
  Cut
};

/** A plane that cuts a tissue: of the points p with p * normal = offset. */
struct CutPlane
{
  /** Of length 1. */
  Point  normal = { { 0.0, 0.0, 0.0 } };
  double offset = 0.0;
  /** How far from it triangles may be that lie in it. */
  double tolerance = 0.0;
};

/** The planes of an image's border; none without an image. */
std::vector<CutPlane>
FindBorder(const ImageGrid & grid);

/** Tells of each triangle whether it is on the surface of the tissue. A void is what a surface towards the exterior
 * holds that faces inwards. */
std::vector<TrianglePlace>
FindSurface(const WallMesh & mesh);

/** Marks the triangles of the surface that are cut by planes: all points are near one, and the triangle is within 60
 * degrees parallel to such a one. \param mayBeCut tells of a cell whether it may be. */
void
MarkCut(const WallMesh & mesh, const std::vector<CutPlane> & planes, const std::function<bool(VertexId)> & mayBeCut,
        std::vector<TrianglePlace> & places);
} // namespace tissue

#endif
