/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ReconstructionParameters_h
#define TissueTessellationCore_ReconstructionParameters_h

#include "TissueTessellationCore/Dual/CornerRule.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

namespace tissue
{
/** Where the adjacency complex comes from. */
enum class ComplexSource
{
  /** The label image: its corners are the tetrahedra, with every wall as often as the image has it. */
  Image,
  /** The centres of the cells, by their Delaunay tetrahedralization (paper, section 3): a simplicial complex. */
  Centers
};

/** What is right before all else where the image's walls and junctions cannot all be: an image asks for junctions of
 * cells that do not all touch. */
enum class AdjacencyPreference
{
  Junctions,
  Walls
};

/** \brief All that can be chosen between a JunctionSet and its wall mesh. A default-constructed object is the preset
 * for label images, also for those made of points, PaperPreset() the paper's method to the letter, PaperPointsPreset()
 * that for points alone. */
struct ReconstructionParameters
{
  ComplexSource source = ComplexSource::Image;
  /** Of a complex from the image. */
  AdjacencyPreference preference = AdjacencyPreference::Walls;

  /** Of a complex from centres, as all that follows up to the corners: l_max of the clean-up, in the image's units; 0:
   * maximumEdgeLengthFactor times the median distance of neighbours.
   */
  double maximumEdgeLength = 0.0;
  double maximumEdgeLengthFactor = 1.4;
  /** Whether the automatic l_max follows the local spacing of the centres (LocalSpacing.h) in place of the median
   * distance; it does where no neighbours are known. */
  bool localMaximumEdgeLength = false;

  EnergyParameters    energy;
  AnnealingParameters annealing;

  /** Of a complex from centres. */
  CornerRule corners = CornerRule::ImageJunction;
  /** Whether the walls are fitted to the label image, where there is one (WallFitting.h); else they are smoothed stars.
   */
  bool fitToImage = true;
  /** Of the fitted walls: the wanted number, each counted once; 40 .. 10000. */
  double trianglesPerCell = 150.0;
  /** Times that every triangle of the stars is split in four; 0 .. 3. Fitted walls at 0 are the fitted stars. */
  int refinement = 1;
  /** Iterations of the smoothing; 0 or more. Fitted walls have none. */
  int smoothingIterations = 10;

  /** Whether every stage keeps its tetrahedra (ReconstructionStage). */
  bool keepStages = false;

  /** Sections 3 and 4 of the paper: one complex, clean-up by length alone, geometric legality, projected Delaunay
   * rings, the energy of three terms at the paper's weights, corners from the cell centres. */
  static ReconstructionParameters
  PaperPreset();

  /** The same for points alone (section 4.3), without the image term, with l_max by the local spacing and the surface
   * where it is. By the paper's terms alone the complex becomes more regular than the tissue and loses adjacencies (its
   * Table 2): a weight on the deviation from Delaunay is added to the energy, lengths are in units of the local
   * spacing, at a weight (15) that keeps them in balance with it, and the first temperature is a tenth. */
  static ReconstructionParameters
  PaperPointsPreset();

  /** \throws std::invalid_argument that names the parameter, its value and its range. */
  void
  Check() const;
};
} // namespace tissue

#endif
