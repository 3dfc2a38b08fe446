/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LabelDivision_h
#define TissueTessellationCore_LabelDivision_h

#include "Nerve/ImageNerve.h"
#include "Nerve/KuhnWall.h"
#include "Nerve/PlaceUpdate.h"

namespace tissue
{
/** A cell, or the exterior, that was divided, and into how many vertices. */
struct DividedCell
{
  VertexId     cell;
  std::int32_t numberOfPieces;
};

/** \brief A label image whose cells are divided where their walls need corners. */
struct LabelDivision
{
  LabelDivision() = default;

  /** Nothing divided yet. */
  LabelDivision(LabelVolume undivided, VertexId numberOfVertices);

  /** In the place of the image in physical space, but with exterior around it where it had not enough. */
  LabelVolume volume;
  /** The cell, or ExteriorVertex, that each vertex of the volume is a piece of; a whole cell's is itself. */
  std::vector<VertexId> realOf;
  /** Of the last Divide(): whether the volume got exterior around it, and the voxels that changed beside that. */
  bool                     isPadded = false;
  std::vector<VoxelChange> changes;

  VertexId
  NumberOfVertices() const
  {
    return static_cast<VertexId>(realOf.size());
  }

  /** Ascending. */
  std::vector<DividedCell>
  FindDividedCells() const;
};

/** A cell that is to be divided although its walls are sound: it is around others, so that its surface is in pieces, or
 * one of its walls is a sphere but for a small hole, which its few corners at the hole tell nothing of, or it has
 * handles. */
struct SplitCell
{
  VertexId cell;
  /** Across the walls within. */
  std::vector<KuhnEdge> walls;
};

/** \brief Divides cells so that the nerve has all of an image's walls.
 *
 * The nerve knows a wall by its corners. A wall is in it as it is in the image if its boundary is one circle, with
 * corners: a disk. One that is closed, that has several boundaries, or that ends at a line without corners, is not:
 * around a cell that touches one or two others, or within another one, or that runs through air like a bar. Where one
 * of the cells of such a wall is taken for several, the walls between these end on it, make corners, and cut it into
 * disks. The larger one of the two cells is divided, the one around the other as a rule, among seeds spread over the
 * wall: the exterior in a layer at the wall; a cell as far from the wall as that is wide, or the whole of it where the
 * wall is around what is within. Pieces whose walls are not yet disks are divided again, in a few rounds.
 *
 * The pieces of a cell are cells of the nerve, those of the exterior are exterior. What the walls between them are like
 * means nothing, and they are to be dropped in the end.
 *
 * \param faulty an edge of the Kuhn subdivision across each wall that is no disk.
 * \param split its cells are divided although all of their walls may be disks.
 * \returns whether anything was divided. */
bool
Divide(LabelDivision & division, std::vector<KuhnEdge> faulty, std::vector<SplitCell> split);

/** An edge across each wall that is not in the nerve as it is in the image. Only those of two cells that have another
 * number of walls in the one than in the other are looked at. */
std::vector<KuhnEdge>
FindFaultyWalls(const LabelVolume & volume, const std::vector<ImageWall> & walls, const GeneralComplex & nerve);

/** The cells, or the exterior, across walls that are nearly all of another cell's surface (three quarters of its
 * faces), with these walls. */
std::vector<SplitCell>
FindCellsAround(const LabelVolume & volume, const std::vector<ImageWall> & walls, VertexId numberOfVertices);

/** Cells, ascending, with all of their walls: to divide the whole of them. */
std::vector<SplitCell>
WithAllWalls(const LabelVolume & volume, const std::vector<ImageWall> & walls, const std::vector<VertexId> & cells);

/** The cells that have several links in the nerve, with the walls of all but the largest. */
std::vector<SplitCell>
FindSplitCells(const LabelVolume & volume, const std::vector<ImageWall> & walls, const GeneralComplex & nerve);
} // namespace tissue

#endif
