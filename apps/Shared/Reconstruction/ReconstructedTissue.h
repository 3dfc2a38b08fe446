/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructedTissue_h
#define ReconstructedTissue_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"
#include "TissueTessellationCore/Statistics/TissueStatistics.h"
#include "itkCellWallMesh.h"

namespace tissue
{
/** The mesh of a tissue's walls, the complex it is the dual of, and what is found of it. */
struct ReconstructedTissue
{
  itk::CellWallMesh::Pointer mesh;
  CellSurfaceCheck           check;
  TissueStatistics           statistics;
  /** Time on the wall of the check and the statistics. */
  double checkSeconds = 0.0;
};

/** \brief Reconstructs the tissue of an input.
 *
 * \param volume the labels that the walls are fitted to, or null; they are freed when that is done.
 * \throws FileError of the input's file. */
ReconstructedTissue
Reconstruct(const TissueInput & input, itk::TissueLabelVolume::Pointer volume,
            const ReconstructionParameters & parameters, ProgressBar & progress);
} // namespace tissue

#endif
