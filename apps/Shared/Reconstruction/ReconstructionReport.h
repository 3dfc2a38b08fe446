/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionReport_h
#define ReconstructionReport_h

#include "Shared/Projection/Projection.h"
#include "Shared/Reconstruction/OutputPaths.h"
#include "Shared/Reconstruction/ReconstructedTissue.h"
#include "Shared/Reconstruction/StageEvaluation.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include <nlohmann/json.hpp>

#include <ostream>

namespace tissue
{
/** Everything that is reported of a run. */
struct ReconstructionReport
{
  std::string                            program;
  nlohmann::ordered_json                 options;
  const TissueInput &                    input;
  const ReconstructedTissue &            tissue;
  const std::optional<StageEvaluation> & evaluation;
  const Projection &                     projection;
  const ProjectedData &                  projected;

  const TissueReconstruction &
  GetReconstruction() const
  {
    return tissue.mesh->GetReconstruction();
  }

  /** The exterior and the cells. */
  const std::vector<Cell> &
  GetCells() const
  {
    return input.GetJunctionSet().cells;
  }

  /** Points alone have no walls, lines and junctions in an image, and no volumes, to compare with. */
  bool
  HasLabelImage() const
  {
    return !input.GetJunctionSet().walls.empty();
  }

  /** The pieces of the exterior that the tissue encloses. */
  std::int32_t
  NumberOfVoids() const
  {
    return GetCells()[ExteriorVertex].numberOfPieces - 1;
  }

  /** Whether the voxels of an image are known: of the label image, or of that of the nuclei. */
  bool
  HasVoxels() const
  {
    return input.image.size[0] > 0;
  }
};

/** \brief The report as JSON: program, input, options, stages, cleanUp, cycles, mesh, warnings, remarks, seconds.
 *
 * What there is not, as agreement with an image for points alone, is null.
 * All times are in `seconds`: without it, reports of the same input and options are the same. */
nlohmann::ordered_json
ToJson(const ReconstructionReport & report);

/** How far the volumes of the cells are from those in the image. */
struct VolumeErrors
{
  /** Of the relative differences. */
  double mean = 0.0;
  /** The cells that are more than 1 %, and more than 5 %, off. */
  std::size_t           numberAboveOnePercent = 0;
  std::vector<VertexId> aboveFivePercent;
};

/** Nothing where there is no label image. */
std::optional<VolumeErrors>
MeasureVolumeErrors(const ReconstructionReport & report);

/** Where the mesh is not what a user may expect, in words, one line each: cells that are missing, no closed spheres or
 * more than 5 % off their volume, points of more than four cells, triangles that cross. */
std::vector<std::string>
CollectFaults(const ReconstructionReport & report);

/** What the user must know: of the input, and the faults of the mesh. One line each. */
std::vector<std::string>
CollectWarnings(const ReconstructionReport & report);

/** The gravest of the remarks, and of several of its kind that of the largest value; for volumes that farthest from 1.
 */
std::optional<CellRemark>
FindWorstRemark(const ReconstructionReport & report);

/** \throws StrictError where it is to be strict and the mesh has faults. */
void
RequireNoFaults(const ReconstructionReport & report, bool isStrict);

/** The remarks on cells: those that the check of the mesh makes, then those of the reconstruction. */
std::vector<CellRemark>
CollectAllRemarks(const ReconstructionReport & report);

/** The labels of cells. */
std::vector<Label>
LabelsOf(const std::vector<VertexId> & vertices, const std::vector<Cell> & cells);

/** The report for a person: the input, the stages as the rows of the paper's Table 1, the mesh, the remarks on cells by
 * kind, the files written, and in the last lines how good the mesh is. */
void
Print(const ReconstructionReport & report, const OutputPaths & outputs, std::ostream & stream);

/** Writes the warnings on standard error and, unless it is to be quiet, the report on standard output. */
void
Say(const ReconstructionReport & report, const OutputPaths & outputs, bool isQuiet);
} // namespace tissue

#endif
