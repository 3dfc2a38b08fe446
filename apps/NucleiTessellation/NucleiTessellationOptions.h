/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef NucleiTessellationOptions_h
#define NucleiTessellationOptions_h

#include "Shared/CommandLine/RunOptions.h"
#include "Shared/Points/NucleiSearch.h"
#include "Shared/Points/PointFileOptions.h"
#include "Shared/Projection/ProjectionOptions.h"
#include "Shared/Reconstruction/MembraneInput.h"
#include "Shared/Reconstruction/MethodOptions.h"
#include "Shared/Reconstruction/OutputPaths.h"
#include "Shared/Reconstruction/StageEvaluation.h"

#include <nlohmann/json_fwd.hpp>

namespace tissue
{
/** Where the centres of the cells are from, and what is made of them. */
struct CenterOptions
{
  /** The file of the points, or the image of their nuclei; empty with centersOf. */
  std::string file;
  /** A label image whose cells' centres are the points, in place of a file of points; empty: none. */
  std::string centersOf;
  /** What the file of points does not say itself. */
  PointFileOptions points;
  /** An image that fills the box that the points were seen in; empty: that of another image, or none is known. */
  std::string box;
  /** How the image is read that they are from, or else that of the membranes or the box. */
  ImageOptions image;
  /** How the nuclei are found, if their image is given in place of points. */
  DetectionOptions detection;
  /** Of the label image made of the points; 50 .. 1e6. */
  double voxelsPerCell = 4000.0;
  /** Whether points far from all others are left out. */
  bool dropsOutliers = false;
  /** Whether the tissue is one layer of cells: auto, on or off. */
  std::string layer = "auto";

  /** The file that the cells are from. */
  const std::string &
  Source() const
  {
    return centersOf.empty() ? file : centersOf;
  }
};

/** What the user asked of the program. */
struct NucleiTessellationOptions
{
  CenterOptions     centers;
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
    files.insert(files.end(), { centers.Source(), membrane.file, evaluation.against, centers.box });
    return files;
  }
};

/** The options of the command line, or nothing after --help and the like, which have then been answered.
 * \throws std::exception that names the option and what is wrong with it. */
std::optional<NucleiTessellationOptions>
ParseCommandLine(int argc, char ** argv);

/** The options for the report. */
nlohmann::ordered_json
ToJson(const NucleiTessellationOptions & options);
} // namespace tissue

#endif
