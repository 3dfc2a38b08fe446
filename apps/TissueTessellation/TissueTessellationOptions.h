/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationOptions_h
#define TissueTessellationOptions_h

#include "Shared/Reconstruction/ReconstructionOptions.h"

#include <nlohmann/json_fwd.hpp>

namespace tissue
{
/** The options of the command line, or nothing after --help and --version, which have then been answered.
 * \throws std::exception that names the option and what is wrong with it. */
std::optional<ReconstructionOptions>
ParseCommandLine(int argc, char ** argv);

/** The options for the report. */
nlohmann::ordered_json
ToJson(const ReconstructionOptions & options);
} // namespace tissue

#endif
