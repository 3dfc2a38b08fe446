/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallFitting_h
#define TissueTessellationCore_WallFitting_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
class AdjacencyComplex;
struct JunctionSet;
struct LabelVolume;

/** \brief How the fit of the walls went. */
struct WallFittingStatistics
{
  /** The number of corners whose four cells do not meet in the image, or not near the corner. */
  std::int64_t unfittedCorners = 0;
  /** The number of unfitted corners of each cell, by vertex. */
  std::vector<std::int32_t> unfittedCornersOfCell;
  /** The pairs of triangles of the first star that crossed and were parted, and those that no search could part. */
  std::int64_t untangledPairs = 0;
  std::int64_t crossingPairs = 0;
  /** The number of walls that stay a subdivided star or outline at first, as they would cross others if remeshed. */
  std::int64_t starWalls = 0;
};

/** \brief Makes the walls of the complex's dual and fits them to the label image.
 *
 * Corners, triple lines and walls go to where the smoothed indicators of their cells are equal (IndicatorField), and
 * the cells get their volumes. No two triangles cross unless the statistics say so.
 *
 * The first points of the mesh are the corners, in the order of AdjacencyComplex::GetTetrahedra(); the walls are in the
 * order of the `ranks` of their cells, one for each vertex. These should be spatial (SpatialOrder()): work on walls one
 * after another then takes no longer for a wall of a large tissue than for one of a small tissue. The number of
 * triangles approaches `trianglesPerCell`, each triangle counted once. Where it is 0 walls are the stars alone, whose
 * points are the corners, then the centres of the walls, except for walls that are far from the image
 * (TriangulateFarOutlines()). The result is the same for any `execution`.
 * \throws Aborted where `execution` asks to stop. */
WallMesh
FitWalls(const AdjacencyComplex & complex, const JunctionSet & junctions, const LabelVolume & volume,
         const std::vector<VertexId> & ranks, double trianglesPerCell, WallFittingStatistics * statistics = nullptr,
         const Execution & execution = Execution());
} // namespace tissue

#endif
