/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/NucleiTessellationOptions.h"

#include "Shared/Points/PointFileReader.h"
#include "Shared/Reconstruction/MethodOptions.h"

namespace tissue
{
namespace
{
/** Whether the points come from a label image must be known before the files are. */
void
AddInputOptions(CLI::App & app, bool hasLabels, NucleiTessellationOptions & options)
{
  if (!hasLabels)
  {
    app
      .add_option(
        "points",
        options.labels,
        "Centres of cells or nuclei (.csv, .fcsv, .mrk.json or .vtp), or an image of nuclei; none with --centersOf")
      ->required()
      ->type_name("FILE");
  }
  const std::string group = "Points";
  app
    .add_option("--centersOf", options.centersOf, "Label image, in place of points: the centres of its cells are they")
    ->type_name("FILE")
    ->group(group);
  app.add_option("--box", options.box, "Image that fills the box that the points were seen in; not read")
    ->type_name("FILE")
    ->group(group);
  app.add_option("--voxelsPerCell", options.voxelsPerCell, "Of the label image that is made of the points")
    ->check(InRange(50.0, 1e6))
    ->capture_default_str()
    ->group(group);
  app
    .add_option(
      "--membrane", options.membrane.file, "Image of bright cell membranes, which is segmented from the points")
    ->type_name("FILE")
    ->group("Membranes");
  AddMembraneOptions(app, options.membrane);
  AddDetectionOptions(app, options.detection);
}
} // namespace

std::optional<NucleiTessellationOptions>
ParseNucleiCommandLine(int argc, char ** argv)
{
  NucleiTessellationOptions options;
  CLI::App app{ "From the centres of a tissue's cells or nuclei to the triangular mesh of all its cell walls.",
                "NucleiTessellation" };
  app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
  const bool hasMembranes = HasOption("--membrane", argc, argv);
  if (!hasMembranes)
  {
    options.parameters = ReconstructionParameters::PointsPreset();
  }
  ApplyPreset(argc,
              argv,
              hasMembranes ? ReconstructionParameters::PaperPreset() : ReconstructionParameters::PaperPointsPreset(),
              options);
  const bool hasLabels = HasOption("--centersOf", argc, argv);
  AddInputOptions(app, hasLabels, options);
  AddOutputOptions(app, options);
  AddEvaluationOption(app, options);
  AddMethodOptions(app, options);
  AddRunOptions(app, options);
  if (!Parse(app, argc, argv))
  {
    return std::nullopt;
  }
  if (hasLabels)
  {
    options.labels = options.centersOf;
  }
  options.otherInputs = { options.box };
  FinishParameters(options);
  return options;
}

nlohmann::ordered_json
ToJson(const NucleiTessellationOptions & options)
{
  nlohmann::ordered_json json;
  json["preset"] = options.preset;
  json["points"] = !options.centersOf.empty()    ? "centres of the cells of a label image"
                   : IsPointFile(options.labels) ? "of the file"
                                                 : "nuclei";
  if (options.centersOf.empty() && !IsPointFile(options.labels))
  {
    const DetectionOptions & d = options.detection;
    json["detection"] = { { "minimumScale", d.minimumScale },
                          { "maximumScale", d.maximumScale },
                          { "stepsPerOctave", d.stepsPerOctave },
                          { "threshold", d.threshold },
                          { "relativeThreshold", d.relativeThreshold },
                          { "maximumOverlap", d.maximumOverlap },
                          { "maximumHessianRatio", d.maximumHessianRatio },
                          { "borderMargin", d.borderMargin },
                          { "dark", d.isDark } };
  }
  json["box"] = options.box;
  json["voxelsPerCell"] = options.voxelsPerCell;
  json["evaluateAgainst"] = options.evaluateAgainst;
  json["evaluateByLabel"] = options.evaluateByLabel;
  AddToJson(options.membrane, json);
  AddToJson(options.parameters, json);
  return json;
}
} // namespace tissue
