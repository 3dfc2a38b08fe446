/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueComplex_h
#define TissueTessellationCore_TissueComplex_h

#include "Adjacency/ReferenceAdjacency.h"
#include "Dual/ImageDual.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

namespace tissue
{
/** \brief The adjacency complex of a tissue, whichever way it was made, with what the walls are made of. */
struct TissueComplex
{
  /** Its dual; without corners' positions where the complex is made of centres, which leaves them to the CornerRule. */
  ImageDual dual;
  /** The cell of each vertex of the complex. */
  std::vector<VertexId> cellOf;
  /** The image by the vertices of the complex; without voxels where that is the image by cells. */
  LabelVolume volume;
  /** What touches what, by cells. */
  AdjacencyTuples tuples;
};

/** The tissue as the ways to its complex take it. */
struct TissueCells
{
  const JunctionSet & junctions;
  /** What the junctions say of neighbours, by which every stage is measured. */
  const ReferenceAdjacency & reference;
  /** All different. */
  const std::vector<Point> & centers;
  /** The cells in spatial order, and the rank of each in it. */
  const std::vector<VertexId> & order;
  const std::vector<VertexId> & ranks;
};

/** Takes the complex from the image (ImageTopology.h); `result` gets its tetrahedra, its stages, and remarks. */
TissueComplex
TakeComplexFromImage(const TissueCells & cells, const LabelVolume & volume, const ReconstructionParameters & parameters,
                     TissueReconstruction & result, const Execution & execution);

/** Makes the complex from the centres of the cells (paper, section 3); likewise. */
TissueComplex
MakeComplexFromCenters(const TissueCells & cells, const ReconstructionParameters & parameters,
                       TissueReconstruction & result, const Execution & execution);

/** The cells of an image of specks that are too small for fitted walls, ascending; none of an image whose cells are
 * large enough on average. */
std::vector<VertexId>
FindSpecks(const std::vector<Cell> & cells);

/** A stage that has these tetrahedra, and other pairs of cells beside theirs. */
ReconstructionStage
MakeStage(const std::string & name, double seconds, const std::vector<VertexQuadruple> & tetrahedra,
          const AdjacencyTuples & tuples, const TissueCells & cells, const ReconstructionParameters & parameters);
} // namespace tissue

#endif
