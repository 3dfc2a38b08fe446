/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_NerveRepair_h
#define TissueTessellationCore_NerveRepair_h

#include "Nerve/ImageNerve.h"
#include "Nerve/TissuePlaces.h"

namespace tissue
{
/** What was done to a nerve so that every cell has one link. */
enum class RepairKind
{
  /** A part of the complex went whose vertices are all in other parts, too. */
  PartDropped,
  /** Two links of a cell were joined at their edges to the exterior, which may get a handle: as the image has it. */
  JoinedAtExterior,
  /** Two links of a cell were joined at their edges to a cell that had two links there as well. */
  JoinedAtCell,
  /** Two links of a cell were joined by gluing two triangles crosswise. */
  GluedCrosswise,
  /** Links of a cell were brought nearer to each other by a false wall around which there are two tetrahedra. */
  FalseDigon,
  /** Two links of a cell that have no other cell in common were joined by three false walls. */
  Bridged,
  /** A handle of a cell's link was cut, by false walls. */
  HandleCut,
  /** A cell without corners was put into a triangle of its neighbours, with a wall to each: one is false, or two. */
  PutIntoTriangle,
  /** Nothing could be done: the cell has several links still, or none. */
  NotRepaired
};

const char *
ToString(RepairKind kind);

struct NerveRepairRecord
{
  RepairKind kind;
  /** The cell with several links or none; of a part that was dropped the least vertex. */
  VertexId vertex;
  /** The cell or exterior at which it was joined, the first neighbour in the triangle, or the vertex itself. */
  VertexId partner;
};

/** \brief Gives every cell of the image one link.
 *
 * A cell has several links in the nerve where its walls to the exterior are rings around it, or where it has others
 * within; and none where it has no corner. Joining two links cuts such a wall open, by a false wall as small as may be:
 * two triangles are opened at edges from the cell to another vertex, and glued to each other or around a new edge.
 * Which is possible where, and in what order: at the exterior first, which may get a handle (it has one in the image,
 * the hole that the wall runs around); at a cell only where its own links are two, as it may not; crosswise at an edge
 * that both links see; along the shortest path in the link of a common neighbour.
 *
 * Not cured: links of cells with handles, which FindViolations() tells. */
std::vector<NerveRepairRecord>
Repair(ImageNerve & nerve, const TissuePlaces & places);
} // namespace tissue

#endif
