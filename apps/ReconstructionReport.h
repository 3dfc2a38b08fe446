/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionReport_h
#define ReconstructionReport_h

#include "TissueInput.h"
#include "TissueTessellationCore/CellSurfaceCheck.h"
#include "TissueTessellationCore/TissueReconstruction.h"

#include <nlohmann/json_fwd.hpp>

#include <ostream>

namespace tissue
{
/** Everything that is reported of a run. */
struct ReconstructionReport
{
  const TissueTessellationOptions & options;
  const TissueInput &               input;
  const TissueReconstruction &      reconstruction;
  const CellSurfaceCheck &          check;
  double                            checkSeconds = 0.0;
};

/** The report as JSON: program, input, options, stages, mesh, seconds, warnings, and every remark on a cell. */
nlohmann::ordered_json
ToJson(const ReconstructionReport & report);

/** The report for a person: the stages as the rows of the paper's Table 1, the mesh, and the remarks by kind. */
void
Print(const ReconstructionReport & report, std::ostream & stream);
} // namespace tissue

#endif
