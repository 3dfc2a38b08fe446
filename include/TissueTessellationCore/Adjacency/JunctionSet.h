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
/** A cell as the label image shows it. The exterior is the cell at index ExteriorVertex: its voxels are those within
 * the image but those of JunctionSet::voids, its largest piece is the one around the tissue, and its other pieces are
 * voids too small to be vertices. A void is a cell of one piece with the exterior's label. */
struct Cell
{
  /** Of the exterior: the label that stands for it, or one that no cell has if only the outside of the image does. */
  Label label = 0;
  /** Barycentre of the cell's largest face-connected piece; meaningless for the exterior. */
  Point center = { { 0.0, 0.0, 0.0 } };
  /** Volume of all of the cell's voxels, in cubed physical units. */
  double volume = 0.0;
  /** Voxels of all of the cell's pieces. */
  std::int64_t numberOfVoxels = 0;
  /** Voxels outside the largest face-connected piece. */
  std::int64_t numberOfStrayVoxels = 0;
  /** Face-connected pieces; 1 for a sound cell. */
  std::int32_t numberOfPieces = 1;
  /** A voxel of the cell shares a face with the exterior label, a void too, or with the outside of the image. */
  bool touchesExterior = false;
  /** A voxel of the cell lies on the border of the image: the cell may be cut there. */
  bool touchesBorder = false;
};

/** The interface of two cells: all voxel faces between them. */
struct Wall
{
  /** Ascending; the exterior, being vertex 0, comes first. */
  VertexPair   cells = { { 0, 0 } };
  std::int64_t numberOfFaces = 0;
  /** Sum of the areas of the faces (a staircase estimate), in squared physical units. */
  double area = 0.0;
  /** Area-weighted mean of the faces' centres. */
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
  /** All blocks that hold the four labels. */
  std::int64_t numberOfBlocks = 0;
  /** Blocks that hold these four labels and no other. */
  std::int64_t numberOfExactBlocks = 0;
  /** Mean of the blocks' centres over the largest cluster of blocks (Chebyshev distance of neighbours at most 2), the
   * cluster of the first block in raster order where several are as large. */
  Point position = { { 0.0, 0.0, 0.0 } };
  /** Clusters of the blocks: above one, the four cells meet at several places. */
  std::int32_t numberOfClusters = 1;
};

/** How sure it is that four cells meet, where cells are estimates. */
struct JunctionVote
{
  VertexQuadruple cells = { { 0, 0, 0, 0 } };
  /** Of the votes those for it, above 0, at most 1. */
  double share = 1.0;
};

/** \brief Everything the topological optimization takes from a label image (paper, section 3.4).
 *
 * The vertices of the adjacency complex are the indices of `cells`, the exterior first, then the cells in ascending
 * order of their labels; then come those of `voids`: each is a place of its own where cells meet the exterior, for
 * which one vertex would not do (a cell of a hollow tissue of one layer meets it on two sides). All other lists are
 * sorted by `cells` and hold each tuple once, the tuples in ascending order. The outside of the image counts as
 * exterior, so a wall of a cell cut by the border is a wall to the exterior. A block of more than four labels counts
 * for each of its subsets of three and of four. */
struct JunctionSet
{
  std::vector<Cell>       cells;
  std::vector<Cell>       voids;
  std::vector<Wall>       walls;
  std::vector<TripleLine> tripleLines;
  std::vector<Junction>   junctions;
  /** Of estimated cells (TissueVotes.h); empty where the image is taken at its word. */
  std::vector<JunctionVote> votes;
  /** 2x2x2 blocks with more than four labels. */
  std::int64_t numberOfCrowdedBlocks = 0;

  VertexId
  NumberOfVertices() const
  {
    return static_cast<VertexId>(cells.size() + voids.size());
  }

  const Cell &
  CellOfVertex(VertexId v) const
  {
    const auto i = static_cast<std::size_t>(v);
    return i < cells.size() ? cells[i] : voids[i - cells.size()];
  }

  bool
  IsVoid(VertexId v) const
  {
    return static_cast<std::size_t>(v) >= cells.size();
  }
};

/** The wall of two cells, given in any order; nullptr where the image has none. */
const Wall *
FindWall(const JunctionSet & junctions, VertexPair cells);

/** The junction of four cells, given in any order; nullptr where the image has none. */
const Junction *
FindJunction(const JunctionSet & junctions, VertexQuadruple cells);

/** Median distance of the centres of the cells that share a wall, which default limits are multiples of; 0 where no two
 * cells do. */
double
MedianNeighborDistance(const JunctionSet & junctions);
} // namespace tissue

#endif
