/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationOptions_h
#define TissueTessellationOptions_h

#include "Shared/CommandLine/RunOptions.h"
#include "Shared/Projection/ProjectionOptions.h"
#include "Shared/Reconstruction/LabelImageInput.h"
#include "Shared/Reconstruction/MembraneInput.h"
#include "Shared/Reconstruction/MethodOptions.h"
#include "Shared/Reconstruction/OutputPaths.h"
#include "Shared/Reconstruction/StageEvaluation.h"

#include <nlohmann/json_fwd.hpp>

namespace tissue
{
/** What the user asked of the program. The cells are from an image of labels, or else of membranes. */
struct TissueTessellationOptions
{
  LabelImageOptions image;
  MembraneOptions   membrane;
  OutputPaths       outputs;
  EvaluationOptions evaluation;
  ProjectionOptions projection;
  MethodOptions     method;
  RunOptions        run;

  /** All files that are read; some may be empty. */
  std::vector<std::string>
  InputFiles() const
  {
    std::vector<std::string> files = projection.Files();
    files.insert(files.end(), { image.file, membrane.file, evaluation.against });
    return files;
  }
};

/** The options of the command line, or nothing after --help and the like, which have then been answered.
 * \throws std::exception that names the option and what is wrong with it. */
std::optional<TissueTessellationOptions>
ParseCommandLine(int argc, char ** argv);

/** The options for the report. */
nlohmann::ordered_json
ToJson(const TissueTessellationOptions & options);
} // namespace tissue

#endif
