/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_JunctionSet_h
#define TissueTessellationCore_JunctionSet_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** The place of an image's voxels in physical space. Of no image the size is 0. */
struct ImageGrid
{
  std::array<std::int32_t, 3> size = { { 0, 0, 0 } };
  /** The centre of the first voxel. */
  Point origin = { { 0.0, 0.0, 0.0 } };
  /** The step to the next voxel along each axis of the image. */
  std::array<Point, 3> steps = { { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } } };
};

/** A cell as the label image shows it. The exterior is the cell at index ExteriorVertex. Its largest piece is the one
 * around the tissue, the outside of the image included; its other pieces are voids that the tissue encloses. */
struct Cell
{
  /** The label in the image. The exterior has the label that stands for it, or, if only the outside of the image is
   * exterior, one that no cell has. */
  Label label = 0;
  /** The barycentre of the cell's largest face-connected piece; it means nothing for the exterior. */
  Point center = { { 0.0, 0.0, 0.0 } };
  /** The volume of all of the cell's voxels, in cubed physical units. */
  double volume = 0.0;
  /** The number of voxels in all of the cell's pieces. */
  std::int64_t numberOfVoxels = 0;
  /** The number of voxels outside of the largest face-connected piece. */
  std::int64_t numberOfStrayVoxels = 0;
  /** The number of face-connected pieces, which is 1 for a sound cell. */
  std::int32_t numberOfPieces = 1;
  /** Whether a voxel of the cell shares a face with the exterior's label, be it in a void, or with the outside of the
   * image. */
  bool touchesExterior = false;
  /** Whether a voxel of the cell lies on the border of the image, where the cell may be cut. */
  bool touchesBorder = false;
};

/** The interface of two cells: all voxel faces between them. */
struct Wall
{
  /** The two cells, ascending: the exterior, being vertex 0, comes first. */
  VertexPair   cells = { { 0, 0 } };
  std::int64_t numberOfFaces = 0;
  /** The sum of the faces' areas, in squared physical units; as the faces are a staircase, it is too large for slanted
   * walls. */
  double area = 0.0;
  /** The mean of the faces' centres, weighted by their areas. */
  Point center = { { 0.0, 0.0, 0.0 } };
};

/** The line where three cells meet: the 2x2x2 blocks of voxels that hold all three labels. */
struct TripleLine
{
  VertexTriple cells = { { 0, 0, 0 } };
  std::int64_t numberOfBlocks = 0;
};

/** The point where four cells meet: the 2x2x2 blocks of voxels that hold all four labels. */
struct Junction
{
  VertexQuadruple cells = { { 0, 0, 0, 0 } };
  /** The number of blocks that hold the four labels. */
  std::int64_t numberOfBlocks = 0;
  /** The number of blocks that hold these four labels and no other. */
  std::int64_t numberOfExactBlocks = 0;
  /** The mean of the blocks' centres over the largest cluster of blocks, in which neighbours have a Chebyshev distance
   * of at most 2. Where several clusters are as large, it is that of the first block in raster order. */
  Point position = { { 0.0, 0.0, 0.0 } };
  /** The number of clusters of the blocks: where it is above one, the four cells meet at several places. */
  std::int32_t numberOfClusters = 1;
};

/** A vote that tells how sure it is that four cells meet, where cells are estimates. */
struct JunctionVote
{
  VertexQuadruple cells = { { 0, 0, 0, 0 } };
  /** The share of the votes that are for it, above 0 and at most 1. */
  double share = 1.0;
};

/** \brief Everything the topological optimization takes from a label image (paper, section 3.4).
 *
 * The vertices of the adjacency complex are the indices of `cells`, the exterior first, then the cells in ascending
 * order of their labels. All other lists are sorted by `cells` and hold each tuple once, with its vertices ascending.
 * The outside of the image counts as exterior, so that a cell cut by the border has a wall to the exterior there. A
 * block of more than four labels counts for each of its subsets of three and of four. */
struct JunctionSet
{
  std::vector<Cell>       cells;
  std::vector<Wall>       walls;
  std::vector<TripleLine> tripleLines;
  std::vector<Junction>   junctions;
  /** The votes on the quadruples of estimated cells (TissueVotes.h); empty where the image is taken at its word. */
  std::vector<JunctionVote> votes;
  /** The number of 2x2x2 blocks with more than four labels. */
  std::int64_t numberOfCrowdedBlocks = 0;
  /** Of the image that all this is from. */
  ImageGrid grid;
  /** All labels that stand for the exterior, ascending, whether the image has them or not. */
  std::vector<Label> exteriorLabels;

  VertexId
  NumberOfVertices() const
  {
    return static_cast<VertexId>(cells.size());
  }

  const Cell &
  CellOfVertex(VertexId v) const
  {
    return cells[static_cast<std::size_t>(v)];
  }
};

/** Returns the wall of two cells, given in any order, or nullptr where the image has none. */
const Wall *
FindWall(const JunctionSet & junctions, VertexPair cells);

/** Returns the junction of four cells, given in any order, or nullptr where the image has none. */
const Junction *
FindJunction(const JunctionSet & junctions, VertexQuadruple cells);

/** Returns the median distance of the centres of cells that share a wall, of which default limits are multiples; 0
 * where no two cells share one. */
double
MedianNeighborDistance(const JunctionSet & junctions);
} // namespace tissue

#endif
