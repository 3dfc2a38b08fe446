/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_KuhnFragments_h
#define TissueTessellationCore_KuhnFragments_h

#include "Nerve/VoxelBox.h"

#include <cstddef>
#include <vector>

namespace tissue
{
/** A piece of a cell that is not its largest one. */
struct Fragment
{
  VertexId     cell;
  std::int64_t numberOfVoxels;
  /** Of a large fragment the vertex of its own, one that no cell has; of a small one the vertex that absorbs it. */
  VertexId vertex;
  bool     isLarge;
};

/** Consecutive voxels of the image, [begin, end) in LabelVolume::vertices, and the vertex that they are to be of. */
struct VoxelRange
{
  std::size_t begin;
  std::size_t end;
  VertexId    vertex;
};

/** The fragments of an image, and how to make every vertex one piece. */
struct Fragments
{
  std::vector<Fragment> fragments;
  /** With those of large fragments, which follow the image's. */
  VertexId                numberOfVertices;
  std::vector<VoxelRange> ofLarge;
  std::vector<VoxelRange> ofSmall;
  /** Of each vertex, around its voxels in the image and around those that it is to have. */
  std::vector<VoxelBox> boxes;
};

/** \brief Finds what makes a cell several pieces in the Kuhn subdivision of the grid, in which it would have a split
 * link.
 *
 * Voxels are neighbours there where a step of 0 or 1 along each axis leads from one to the other: face neighbours, and
 * some by edges and corners, so fewer pieces are fragments than by faces. Each cell keeps its largest piece, of several
 * the first in raster order. Other pieces of at least `minimumVoxels` become vertices of their own, in the order of
 * their first voxels: closed pieces of the cell's surface. Smaller ones go to the vertex of the most common faces among
 * the pieces that stay, of several to the least; a fragment that touches such fragments alone goes where they have
 * gone. The exterior may have any number of pieces.
 *
 * The image's places are to be found with the large fragments relabelled alone: what small ones touch, their cells do.
 * The nerve is to be made with both relabelled. */
Fragments
FindFragments(const LabelVolume & volume, VertexId numberOfVertices, std::int64_t minimumVoxels = 4);

/** Gives the voxels of the ranges their vertices. */
void
Relabel(LabelVolume & volume, const std::vector<VoxelRange> & ranges);
} // namespace tissue

#endif
