/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef CommandLineParts_h
#define CommandLineParts_h

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/Reconstruction/ReconstructionOptions.h"

#include <nlohmann/json.hpp>

namespace tissue
{
/** The mesh of the walls, required, and all further outputs. */
void
AddOutputOptions(CLI::App & app, ReconstructionOptions & options);

/** The image of membranes and how it is segmented. */
void
AddMembraneOptions(CLI::App & app, MembraneOptions & options);

void
AddEvaluationOption(CLI::App & app, ReconstructionOptions & options);

/** The preset, which must have been applied by ApplyPreset(), and the parameters that override it. */
void
AddMethodOptions(CLI::App & app, ReconstructionOptions & options);

void
AddRunOptions(CLI::App & app, ReconstructionOptions & options);

/** Sets the parameters to those of the paper if the command line asks for them. The preset must be known before the
 * options that override it are read. */
void
ApplyPreset(int argc, char ** argv, const ReconstructionParameters & paper, ReconstructionOptions & options);

/** Whether an option with a value is on the command line: what else is there may depend on it. */
bool
HasOption(const std::string & name, int argc, char ** argv);

/** Sets what follows from the other options. \throws std::runtime_error for a parameter out of range. */
void
FinishParameters(ReconstructionOptions & options);

/** The parameters for the report. */
void
AddToJson(const ReconstructionParameters & parameters, nlohmann::ordered_json & json);

void
AddToJson(const MembraneOptions & options, nlohmann::ordered_json & json);
} // namespace tissue

#endif
