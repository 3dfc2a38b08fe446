/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ExteriorOptions_h
#define ExteriorOptions_h

#include "Shared/CommandLine/OptionChecks.h"
#include "itkExteriorLabelSettings.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tissue
{
/** Adds --exteriorLabel, --zeroIsCell and --dropCells. `settings` must be as new and outlive the parsing.
 * \param group of the options in the help; empty for none. */
void
AddExteriorOptions(CLI::App & app, const std::string & group, itk::ExteriorLabelSettings & settings);

/** Adds --acceptSpecks. */
CLI::Option *
AddSpeckOption(CLI::App & app, bool & acceptsSpecks);

/** The settings for the report. */
void
AddToJson(const itk::ExteriorLabelSettings & settings, nlohmann::ordered_json & json);
} // namespace tissue

#endif
