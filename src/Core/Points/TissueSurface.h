/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueSurface_h
#define TissueTessellationCore_TissueSurface_h

#include "Points/TissueMask.h"
#include "Tessellation/CentroidFit.h"

#include <vector>

namespace tissue
{
struct MirroredCenters;

/** \brief The surface of a tissue as its cells' centres tell it: the surface triangles of their complex, and how far
 * the surface is above the centres at their corners.
 *
 * A depth is first half the median height of the centre above those of its neighbours below it, but at most 0.6 of the
 * local spacing. This is what a cell as thick as those below it has above its centre. Follow() then fits the depths
 * jointly with the cells (CentroidFit.h): where a seed had to move outwards to bring its cell's centroid to its point,
 * the surface is farther out, by about as much, and the other way round. Neighbours' depths are evened out a little. */
class TissueSurface
{
public:
  /** \param points the centres of the cells.
   * \param box the box of the tissue. A cell whose centre is near a side is taken to be cut by it, and has no surface
   * there.
   * \throws std::invalid_argument as DelaunayTetrahedralization(). */
  TissueSurface(const std::vector<Point> & points, const Box & box);

  /** Moves the surface with the seeds of the points' cells, which come in the order of the points. */
  void
  Follow(const std::vector<MetricSeed> & seeds);

  TissueMask
  MakeMask(const TissueGrid & grid, const Execution & execution = Execution()) const;

  /** Lists the points next to each point in the cleaned complex. */
  CellNeighbors
  FindNeighbors() const;

  /** The local spacing about each point (LocalSpacing.h). */
  double
  Spacing(std::size_t point) const
  {
    return m_Spacings[point + 1];
  }

  /** Tells whether the cell of the point is neither at the surface nor cut by a side of the box. */
  bool
  IsInner(std::size_t point) const
  {
    return m_Depths[point + 1] == 0.0 && !m_IsCut[point + 1];
  }

private:
  TissueSurface(MirroredCenters centers, std::size_t numberOfPoints);

  void
  EstimateDepths();
  void
  EvenOut(double share);

  /** The complex and what is known of its vertices, which are the exterior, the points, and the points' mirror images
   * beyond the sides that cut them. */
  AdjacencyComplex    m_Complex;
  std::vector<Point>  m_Centers;
  std::vector<double> m_Spacings;
  std::vector<Point>  m_Normals;
  std::vector<double> m_Depths;
  /** Tells of the exterior and the points, not of their images, whether a side of the box cuts them. */
  std::vector<bool> m_IsCut;
};
} // namespace tissue

#endif
