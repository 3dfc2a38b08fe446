/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallPart_h
#define TissueTessellationCore_WallPart_h

#include "Nerve/PlaneScan.h"
#include "Nerve/TissuePlaces.h"

namespace tissue
{
/** Faces of a wall of the image: the sums are of twice the coordinates of their centres, so whole. */
struct WallPart
{
  /** Ascending. */
  VertexPair                  cells;
  std::int64_t                numberOfFaces = 0;
  std::array<std::int64_t, 3> sum = { { 0, 0, 0 } };
  /** Twice the centre of the first face in raster order. */
  std::array<std::int64_t, 3> first = { { 0, 0, 0 } };

  void
  AddFace(const std::array<std::int64_t, 3> & twiceCenter)
  {
    ++numberOfFaces;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += twiceCenter[axis];
    }
  }

  /** Those of another part of the same wall, whose first face comes after this one's. */
  void
  AddFaces(const WallPart & part)
  {
    numberOfFaces += part.numberOfFaces;
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += part.sum[axis];
    }
  }
};

/** The wall that has these faces and no other. */
ImageWall
ToImageWall(const LabelVolume & volume, const WallPart & part);

/** The walls, and in the same reading of the image the blocks in which there is something to know. */
std::vector<ImageWall>
FindImageWalls(const LabelVolume & volume, const BlockVisitor & visit, const Execution & execution);

/** The order of TissuePlaces: of walls of the same cells and size that with the first face in raster order first. */
bool
ComesBefore(const ImageWall & a, const ImageWall & b);
} // namespace tissue

#endif
