/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionReport_h
#define ReconstructionReport_h

#include "Shared/Reconstruction/StageEvaluation.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>

namespace tissue
{
/** Everything that is reported of a run. */
struct ReconstructionReport
{
  const std::string &            program;
  const ReconstructionOptions &  options;
  const nlohmann::ordered_json & optionsAsJson;
  const TissueInput &            input;
  const TissueReconstruction &   reconstruction;
  const CellSurfaceCheck &       check;
  double                         checkSeconds = 0.0;
  /** Null unless the stages are judged. */
  const Judge * judge = nullptr;
};

/** \brief The report as JSON: program, input, options, stages, cleanUp, cycles, mesh, warnings, remarks, seconds.
 *
 * What there is not, as agreement with an image for points alone, is null.
 * All times are in `seconds`: without it, reports of the same input and options are the same. */
nlohmann::ordered_json
ToJson(const ReconstructionReport & report);

/** What the user must know: of the input, and where the mesh is not what it should be. One line each. */
std::vector<std::string>
CollectWarnings(const ReconstructionReport & report);

/** The report for a person: the input, the stages as the rows of the paper's Table 1, the mesh, the remarks on cells by
 * kind, and the files written. */
void
Print(const ReconstructionReport & report, std::ostream & stream);
} // namespace tissue

#endif
