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
  /** Corners whose four cells do not meet in the image, or nowhere near. */
  std::int64_t unfittedCorners = 0;
  /** Those of each cell, by vertex. */
  std::vector<std::int32_t> unfittedCornersOfCell;
  /** Pairs of triangles of the first star that crossed, and those that no search could part. */
  std::int64_t untangledPairs = 0;
  std::int64_t crossingPairs = 0;
  /** Walls that stay a subdivided star or outline at first, as their triangles would cross if remeshed. */
  std::int64_t starWalls = 0;
};

/** \brief The walls of the complex's dual, fitted to the label image: corners, triple lines and walls where the
 * smoothed indicators of their cells are equal (IndicatorField), the cells at their volumes, and no two triangles
 * crossing unless the statistics say so.
 *
 * Its points are first the corners, in the order of AdjacencyComplex::GetTetrahedra(); its walls are in the order of
 * the `ranks` of their cells, one for each vertex, which should be spatial (SpatialOrder()): work on walls one after
 * another then takes as long a wall in a large tissue as in a small one. `trianglesPerCell`, each triangle counted
 * once, is approached; 0: the stars alone, whose points are the corners, then the centres of the walls, but for those
 * that are far from the image (TriangulateFarOutlines()). Deterministic for any `execution`. \throws Aborted where
 * `execution` asks to stop. */
WallMesh
FitWalls(const AdjacencyComplex & complex, const JunctionSet & junctions, const LabelVolume & volume,
         const std::vector<VertexId> & ranks, double trianglesPerCell, WallFittingStatistics * statistics = nullptr,
         const Execution & execution = Execution());
} // namespace tissue

#endif
