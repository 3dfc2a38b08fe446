/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImageNerve_h
#define TissueTessellationCore_ImageNerve_h

#include "Nerve/CrowdedBlocks.h"
#include "Nerve/GeneralComplex.h"

namespace tissue
{
/** The line of the image that a triangle of the nerve stands for: where three cells meet, from corner to corner. */
struct ImageLine
{
  /** The point of its path that lies as many steps from the one end as from the other, in physical space. */
  Point middle;
  /** Of its path, smoothed over two or three voxels, in physical units. */
  double length;
};

/** \brief The corners of a label image as tetrahedra, glued along the lines that join them.
 *
 * Where the label image is taken as a piecewise linear map on the Kuhn subdivision of its grid of voxels, each
 * tetrahedron of the subdivision is met by the walls of its labels in the simplest way: four labels meet in one corner,
 * three in one line across, two in one wall. So corners are the tetrahedra of four labels, and each of the four lines
 * that leave a corner runs from tetrahedron to tetrahedron, through triangles of the same three labels, to another
 * corner. It cannot branch or end. Nothing is decided: the nerve is the image's adjacency as it is, with every wall
 * that has corners, as often as it is there.
 *
 * All triangles are glued, and oriented alike in physical space. What the nerve does not have: cells, walls and lines
 * without corners. What it may have, where walls are not disks or cells are in pieces: links that are no spheres, or
 * several. FindVertexLinks() tells of the cells, TissuePlaces of the walls. */
struct ImageNerve
{
  GeneralComplex complex;
  /** By the `corner` of tetrahedra: the mean of the centres of its four voxels, in physical space. */
  std::vector<Point> corners;
  /** By the `lines` of tetrahedra. */
  std::vector<ImageLine> lines;
};

/** Of an image whose voxels are of the vertices 0 ... numberOfVertices - 1, and the crowded blocks of it. Linear in the
 * number of corners and the length of lines. */
ImageNerve
MakeImageNerve(const LabelVolume & volume, VertexId numberOfVertices, const std::vector<CrowdedBlock> & blocks,
               const Execution & execution = Execution());
} // namespace tissue

#endif
