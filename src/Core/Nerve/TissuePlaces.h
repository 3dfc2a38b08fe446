/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissuePlaces_h
#define TissueTessellationCore_TissuePlaces_h

#include "Nerve/CrowdedBlocks.h"

namespace tissue
{
/** A wall of the image: voxel faces between two cells that hang together by their edges. Two cells have as many walls
 * as their interface has pieces. */
struct ImageWall
{
  /** Ascending. */
  VertexPair   cells;
  std::int64_t numberOfFaces;
  /** Mean of the faces' centres, in physical space. */
  Point center;
  /** The voxels at the sides of the wall's first face, that of the least index first; one may be outside of the image.
   */
  std::array<VoxelIndex, 2> face = {};
};

/** A place of the image where four cells meet: 2x2x2 blocks that hold all four and touch each other, if by a corner. A
 * block of more than four cells counts for each four of them. */
struct CornerPlace
{
  /** Ascending. */
  VertexQuadruple cells;
  std::int64_t    numberOfBlocks;
  /** Mean of the blocks' centres, in physical space. */
  Point position;
};

/** \brief What meets what in a label image, and how often. The complex is measured by it. */
struct TissuePlaces
{
  /** Ascending by their cells; of the same cells the largest first. */
  std::vector<ImageWall> walls;
  /** Ascending by their cells; of the same cells in raster order of their first blocks. */
  std::vector<CornerPlace> corners;
};

/** The walls, with those to the outside of the image. Slabs of the image are read in parallel; the memory is that of
 * some planes for each slab. */
std::vector<ImageWall>
FindImageWalls(const LabelVolume & volume, const Execution & execution = Execution());

/** The places of the crowded blocks of the image. */
std::vector<CornerPlace>
FindCornerPlaces(const LabelVolume & volume, const std::vector<CrowdedBlock> & blocks);
} // namespace tissue

#endif
