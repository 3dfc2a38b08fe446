/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MethodOptions_h
#define MethodOptions_h

#include "Shared/CommandLine/OptionChecks.h"
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tissue
{
/** How a tissue is reconstructed. */
struct MethodOptions
{
  /** "default" or "paper". */
  std::string preset = "default";
  /** Those of the preset, but for what the user chose. */
  ReconstructionParameters parameters;
};

/** Which preset it is must be known, by FindOptions(), before the options are made that override it. */
inline const std::string PresetOption = "--preset";

/** Of the options that are refused, as the preset does not know them. */
inline const std::string OtherPresetGroup = "Method of the other preset";

/** The preset that is among the options found, with its parameters. */
MethodOptions
ChoosePreset(const FoundOptions & found, const ReconstructionParameters & byDefault,
             const ReconstructionParameters & ofPaper);

/** The preset, and the parameters that override those that `options` has from ChoosePreset(). */
void
AddMethodOptions(CLI::App & app, MethodOptions & options);

/** \throws std::runtime_error that names the option of a parameter that is out of its range, its value and the range.
 */
void
RequireInRange(const ReconstructionParameters & parameters);

/** The parameters for the report, without those that the way to the complex does not know. */
void
AddToJson(const ReconstructionParameters & parameters, nlohmann::ordered_json & json);
} // namespace tissue

#endif
