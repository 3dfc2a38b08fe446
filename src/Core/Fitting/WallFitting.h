/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallFitting_h
#define TissueTessellationCore_WallFitting_h

#include "Dual/ImageDual.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Fitting/WallFittingStatistics.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

namespace tissue
{
/** \brief The tissue that walls are fitted to. */
struct TissueImage
{
  /** The image by cells, and by the vertices of the complex. */
  const LabelVolume & cells;
  const LabelVolume & vertices;
  /** The cell of each vertex of the complex. */
  std::vector<VertexId> cellOf;
  /** The wanted volume of each cell; the exterior's is ignored. */
  std::vector<double> volumes;
  /** Of the cells. They should be spatial (SpatialOrder()): work on walls one after another then takes no longer for a
   * wall of a large tissue than for one of a small tissue. */
  std::vector<VertexId> ranks;
};

/** \brief Makes the walls of a complex's dual and fits them to the label image.
 *
 * Corners, triple lines and walls go to where the smoothed indicators of their cells are equal (IndicatorField), and
 * the cells get their volumes. No two triangles cross unless the statistics say so. Walls between two vertices of one
 * cell are left out, and walls of the same two cells that meet where one of these was are joined.
 *
 * The first points of the mesh are the corners of four cells, in the order of the dual; the walls are in the order of
 * the ranks of their cells. The number of triangles approaches `trianglesPerCell`, each triangle counted once. Where it
 * is 0 walls are the stars alone, except for walls that are far from the image (TriangulateFarOutlines());
 * so they are where they cross too often to be remeshed. The result
 * is the same for any `execution`. \throws Aborted where `execution` asks to stop. */
WallMesh
FitWalls(ImageDual dual, const TissueImage & tissue, double trianglesPerCell,
         WallFittingStatistics * statistics = nullptr, const Execution & execution = Execution());
} // namespace tissue

#endif
