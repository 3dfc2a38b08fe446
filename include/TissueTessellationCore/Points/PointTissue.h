/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PointTissue_h
#define TissueTessellationCore_PointTissue_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Points/TissueGrid.h"

#include <vector>

namespace tissue
{
/** The box about the points, wider by the greatest distance of a point from its eight nearest.
 * \throws std::invalid_argument as EstimateTissue(). */
Box
PaddedBox(const std::vector<Point> & points);

/** The grid that fills the box with about so many points to a cell, at least 50, and at most 5e8 in all.
 * \throws std::invalid_argument as EstimateTissue(), and for fewer, or for more in all. */
TissueGrid
MakePointGrid(const std::vector<Point> & points, const Box & box, double voxelsPerCell);

/** What centres of cells tell of their tissue. */
struct PointTissue
{
  /** The label image: i + 1 for the cell of point i, 0 for the exterior, in the order of the grid's points. */
  std::vector<std::int32_t> labels;
  /** How sure it is which cells meet: vertex i + 1 is the cell of point i (TissueVotes.h). */
  std::vector<JunctionVote> votes;
};

/** \brief The tissue as its cells' centres tell it: where the tissue is, and the tessellation of it
 * that has its cells' centroids on the points.
 *
 * Surface and cells are fitted jointly (TissueSurface.h, CentroidFit.h), first as if the points were exact. How far the
 * seeds go for it tells how exact they are: in the last sweeps the seeds are held back accordingly, and the votes doubt
 * the cells' shapes.
 *
 * In a grid of more than 700 points to a cell the fit takes only so many: small walls need fine labels, the fit does
 * not.
 *
 * Every point has a cell. The result does not depend on the number of threads.
 * \param grid of the box that is all there is of the tissue: what is outside of it is exterior, and cells may be cut by
 * its sides.
 * \throws std::invalid_argument for fewer than four points, two at one place, all in one plane, one that is not finite
 * or not in the box.
 * \throws Aborted where `execution` asks to stop. */
PointTissue
EstimateTissue(const std::vector<Point> & points, const TissueGrid & grid, const Execution & execution = Execution());
} // namespace tissue

#endif
