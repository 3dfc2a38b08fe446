/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueReconstruction_h
#define TissueTessellationCore_TissueReconstruction_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Complex/SurfaceCleanUp.h"
#include "TissueTessellationCore/Fitting/WallFitting.h"
#include "TissueTessellationCore/Optimization/ComplexStatistics.h"
#include "TissueTessellationCore/Reconstruction/CellRemark.h"
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

namespace tissue
{
/** A stage of the complex, as in the rows of the paper's Table 1. */
struct ReconstructionStage
{
  ComplexStatistics statistics;
  /** Wall-clock time that led to it from the stage before. */
  double seconds = 0.0;
  /** If the parameters say to keep them: vertices as in TissueReconstruction::tetrahedra. */
  std::vector<VertexQuadruple> tetrahedra;
};

/** \brief What ReconstructTissue() made: the complex, its dual, and how it went. Vertices are indices of the cells of
 * the JunctionSet it was made from. */
struct TissueReconstruction
{
  std::vector<VertexQuadruple> tetrahedra;
  WallMesh                     walls;

  ReconstructionStage delaunay;
  ReconstructionStage cleaned;
  ReconstructionStage optimized;
  double              dualSeconds = 0.0;
  /** Whether the walls are fitted to a label image, and how that went. */
  bool                  isFitted = false;
  WallFittingStatistics fitting;

  /** Parts of the tissue that share no junction: the exterior's link has as many spheres. */
  std::size_t numberOfParts = 1;
  /** Enclosed voids that were vertices of their own. */
  std::size_t numberOfVoids = 0;
  /** The l_max that was used; where it follows the local spacing, its median. */
  double                      maximumEdgeLength = 0.0;
  SurfaceCleanUpResult        cleanUp;
  std::vector<AnnealingCycle> cycles;
  /** Vertices that found a better place after the cycles (VertexRelocation.h). */
  std::size_t numberOfRelocatedVertices = 0;
  /** Of the optimized complex. */
  double                  energy = 0.0;
  std::vector<CellRemark> remarks;
};

/** \brief From the junctions of a label image to the mesh of its cell walls (paper, sections 3 and 4.2):
 * Delaunay, clean-up, optimization, dual. Parts of the tissue that share no junction (TissueParts.h) have a complex
 * each.
 *
 * With the `volume` that the junctions come from, the walls are fitted to it unless the parameters say otherwise. What
 * is done by `execution` is the same for any number of threads.
 *
 * Cells whose neighbours are not known (a JunctionSet without walls, as of points alone) have statistics without
 * adjacencies, l_max by the local spacing of their centres, and no remarks that compare them with an image.
 *
 * Every cell of `junctions` is a vertex of the complex and has its closed surface in the mesh. A void is a vertex while
 * the complex is optimized, and then the exterior: in `tetrahedra` and `walls`. Cells with the same
 * centre are moved apart by a thousandth of the cells' typical distance; the remarks say so. \throws
 * std::invalid_argument for parameters out of range, fewer than four cells, and cells whose centres are coplanar.
 * \throws Aborted where `execution` asks to stop. */
TissueReconstruction
ReconstructTissue(const JunctionSet & junctions, const ReconstructionParameters & parameters,
                  const LabelVolume * volume = nullptr, const Execution & execution = Execution());
} // namespace tissue

#endif
