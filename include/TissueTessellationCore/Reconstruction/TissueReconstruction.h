/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueReconstruction_h
#define TissueTessellationCore_TissueReconstruction_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Complex/SurfaceCleanUp.h"
#include "TissueTessellationCore/Fitting/WallFittingStatistics.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"
#include "TissueTessellationCore/Optimization/ComplexStatistics.h"
#include "TissueTessellationCore/Reconstruction/CellRemark.h"
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

#include <string>
#include <vector>

namespace tissue
{
struct LabelVolume;

/** A stage of the complex, as in the rows of the paper's Table 1. */
struct ReconstructionStage
{
  /** Of a complex from the image "nerve" and "optimized"; from centres "delaunay", "cleaned" and "optimized". */
  std::string       name;
  ComplexStatistics statistics;
  /** Wall-clock time that led to it from the stage before. */
  double seconds = 0.0;
  /** If the parameters say to keep them. */
  AdjacencyTuples tuples;
};

/** \brief What ReconstructTissue() made: the complex, its dual, and how it went. Vertices are indices of the cells of
 * the JunctionSet it was made from. */
struct TissueReconstruction
{
  /** The corners of four cells, as AdjacencyComplex::GetTetrahedra() has them; those of a complex from the image may
   * repeat each other. The first points of the walls are theirs. */
  std::vector<VertexQuadruple> tetrahedra;
  WallMesh                     walls;

  /** In their order, one at least. */
  std::vector<ReconstructionStage> stages;
  double                           dualSeconds = 0.0;
  /** Whether the walls are fitted to a label image, and how that went. */
  bool                  isFitted = false;
  WallFittingStatistics fitting;

  /** The l_max that was used; where it follows the local spacing, its median. */
  double                      maximumEdgeLength = 0.0;
  SurfaceCleanUpResult        cleanUp;
  std::vector<AnnealingCycle> cycles;
  /** Of the optimized complex. */
  double                  energy = 0.0;
  std::vector<CellRemark> remarks;
};

/** \brief From a label image to the mesh of its cell walls.
 *
 * The complex is taken from the image (ReconstructionParameters::source), or made of the cells' centres as in the paper
 * (sections 3 and 4.2): Delaunay, clean-up, optimization. Its dual is the mesh. With the `volume` that the junctions
 * come from, the walls are fitted to it unless the parameters say otherwise. What is done by `execution` is the same
 * for any number of threads.
 *
 * Every cell of `junctions` has its closed surface in the mesh. Voids are exterior. Of a complex from centres cells
 * with the same centre are moved apart by a thousandth of the cells' typical distance; the remarks say so. Cells whose
 * neighbours are not known (a JunctionSet without walls, as of points alone) have statistics without adjacencies, l_max
 * by the local spacing of their centres, and no remarks that compare them with an image.
 *
 * \throws std::invalid_argument for parameters out of range, for a complex from the image without a volume, and, from
 * centres, for fewer than four cells and for cells whose centres are coplanar. \throws Aborted where `execution` asks
 * to stop. */
TissueReconstruction
ReconstructTissue(const JunctionSet & junctions, const ReconstructionParameters & parameters,
                  const LabelVolume * volume = nullptr, const Execution & execution = Execution());
} // namespace tissue

#endif
