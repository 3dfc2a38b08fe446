/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef NucleiTessellationOptions_h
#define NucleiTessellationOptions_h

#include "Shared/Points/NucleiSearch.h"
#include "Shared/Reconstruction/ReconstructionOptions.h"

#include <nlohmann/json_fwd.hpp>

namespace tissue
{
/** What the user asked of the program for nuclei. `labels` is the file of the points, or the image of their nuclei. */
struct NucleiTessellationOptions : ReconstructionOptions
{
  /** A label image whose cells' centres are the points, in place of a file of points; empty: none. */
  std::string centersOf;
  /** An image that fills the box that the points were seen in; empty: that of another image, or none is known. */
  std::string box;
  /** How the nuclei are found, if their image is given in place of points. */
  DetectionOptions detection;
  /** Of the label image made of the points. */
  double voxelsPerCell = 4000.0;
};

/** As ParseCommandLine(). */
std::optional<NucleiTessellationOptions>
ParseNucleiCommandLine(int argc, char ** argv);

/** The options for the report. */
nlohmann::ordered_json
ToJson(const NucleiTessellationOptions & options);
} // namespace tissue

#endif
