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
/** Gives the box about the points, wider on all sides by the greatest of their local spacings, the mean distances of
 * their eight nearest.
 * \throws std::invalid_argument as EstimateTissue(). */
Box
PaddedBox(const std::vector<Point> & points);

/** Makes the grid that fills the box with about `voxelsPerCell` points to a cell, which must be at least 50. The grid
 * has at most 5e8 points. \throws std::invalid_argument as EstimateTissue(), for fewer points to a cell, and for a grid
 * of more points. */
TissueGrid
MakePointGrid(const std::vector<Point> & points, const Box & box, double voxelsPerCell);

/** \brief Finds the points that are far from all others, ascending: slips and dust, as a rule.
 *
 * A point is far where its fourth nearest, or the farthest of fewer, is at more than ten times the median of that
 * distance over all points; so are those of groups of up to four. Larger groups are parts of the tissue. */
std::vector<std::size_t>
FindOutliers(const std::vector<Point> & points);

/** The tissue that is estimated from the centres of its cells. */
struct PointTissue
{
  /** The label image in the order of the grid's points, with label i + 1 for the cell of point i and 0 for the
   * exterior.
   */
  std::vector<std::int32_t> labels;
  /** The votes on which cells meet (TissueVotes.h), where vertex i + 1 is the cell of point i. None for a layer: votes
   * tell which cells meet, not how often, and those of a layer meet the exterior twice. */
  std::vector<JunctionVote> votes;
};

/** Whether a tissue is taken for one layer of cells, a sheet or a shell. */
enum class TissueLayering
{
  /** It is where the points show it (TissueLayer.h). */
  Automatic,
  Layer,
  Solid
};

/** \brief Estimates a tissue from its cells' centres: its place, and the tessellation of it that has its cells'
 * centroids on the points.
 *
 * Surface and cells are fitted jointly (TissueSurface.h, CentroidFit.h), first as if the points were exact. How far the
 * seeds go for it tells how exact they are: in the last sweeps the seeds are held back accordingly, and the votes doubt
 * the cells' shapes.
 *
 * Where the grid has more than 700 points to a cell, the fit takes a coarser one of as many: small walls need fine
 * labels, the fit does not.
 *
 * A layer of cells is as thick as its cells are wide, and what it encloses is exterior. Its cells are
 * the points' Voronoi cells in the middle of the layer, drawn out across it; there are no votes on how they meet.
 *
 * Every point has a cell. The result does not depend on the number of threads.
 * \param grid a grid of the box that was seen of the tissue: what is outside of it is exterior, and cells may be cut by
 * its sides.
 * \throws std::invalid_argument for fewer than four points, two at one place, one that is not finite or not in the box,
 * and points in one plane of a tissue that is said to be solid.
 * \throws Aborted where `execution` asks to stop. */
PointTissue
EstimateTissue(const std::vector<Point> & points, const TissueGrid & grid,
               TissueLayering layering = TissueLayering::Automatic, const Execution & execution = Execution());
} // namespace tissue

#endif
