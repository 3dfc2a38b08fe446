/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueProgram_h
#define TissueProgram_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Reconstruction/ReconstructionOptions.h"
#include "Shared/Reconstruction/TissueInput.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace tissue
{
using InputReader = std::function<TissueInput(ProgressBar &)>;

/** \brief What the programs that make a wall mesh have in common: checks that the outputs can be written, reads the
 * input, reconstructs the tissue, writes the outputs, and says how it went.
 *
 * \param optionsAsJson for the report.
 * \throws std::exception that says what is wrong; no output is left then. */
void
RunTissueProgram(const std::string & program, const ReconstructionOptions & options,
                 const nlohmann::ordered_json & optionsAsJson, const InputReader & readInput);
} // namespace tissue

#endif
