/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellation/TissueTessellationOptions.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/SlicerOptions.h"
#include "Shared/Reconstruction/ExteriorOptions.h"
#include "Shared/Reconstruction/ReconstructionModule.h"

#include <nlohmann/json.hpp>

namespace tissue
{
namespace
{
const std::string MembraneOption = "--membrane";
const std::string ImageOption = "--imageIs";
const std::string Membranes = "membranes";

void
AddImageOptions(CLI::App & app, LabelImageOptions & options)
{
  const std::string group = "Image";
  AddExteriorOptions(app, group, options.exterior);
  AddImageOptions(app, options.input);
  AddSpeckOption(app, options.acceptsSpecks)->group(group);
  // A flag with a value, so that the width can be left out: 0 stands for the automatic one.
  app
    .add_flag(
      "--closeGaps{0}",
      "Grow the labels over walls of background between them; --closeGaps WIDTH: over walls up to this width, in "
      "the image's units; 0: a width chosen from the image, as without one")
    ->check(InRange(0.0, 1e12))
    ->group(group);
}

/** Whether the cells come from an image of membranes must be known before the files are. */
void
AddInputOptions(CLI::App & app, const FoundOptions & found, TissueTessellationOptions & options)
{
  const auto imageIs = found.find(ImageOption);
  if (found.count(MembraneOption) == 0)
  {
    const bool areMembranes = imageIs != found.end() && imageIs->second == Membranes;
    app
      .add_option(
        "labels",
        areMembranes ? options.membrane.file : options.image.file,
        "Segmented 3-D image in any of ITK's formats, TIFF, HDF5 (FILE:/NAME) or .inr.gz; none with --membrane")
      ->required()
      ->type_name("FILE");
  }
  const std::string group = "Membranes";
  app
    .add_option(MembraneOption,
                options.membrane.file,
                "Image of cell membranes, in place of the segmented one: its minima are the cells")
    ->type_name("FILE")
    ->group(group);
  app.add_option(ImageOption, "What the image is, where there is no --membrane: labels of the cells, or membranes")
    ->excludes(MembraneOption)
    ->check(CLI::IsMember(std::vector<std::string>{ "labels", Membranes }))
    ->default_str("labels")
    ->group(group);
  app
    .add_option("--markerSigma",
                options.membrane.markerSigma,
                "Smoothing of it for its minima, in the image's units; 0: by a voxel")
    ->check(InRange(0.0, 1e12))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--markerDepth", options.membrane.markerDepth, "Least depth of a minimum, of the range of intensities")
    ->check(InRange(0.0, 1.0))
    ->capture_default_str()
    ->group(group);
  app
    .add_option(
      "--noiseDepth",
      options.membrane.noiseDepth,
      "Least depth of a minimum, of the deviation of the noise that the smoothing leaves; 0: whatever the noise")
    ->check(InRange(0.0, 1e6))
    ->capture_default_str()
    ->group(group);
  AddMembraneOptions(app, "--dark,--darkMembranes", options.membrane);
}
} // namespace

std::optional<TissueTessellationOptions>
ParseCommandLine(int argc, char ** argv)
{
  const FoundOptions        found = FindOptions({ PresetOption, MembraneOption, ImageOption }, argc, argv);
  TissueTessellationOptions options;
  CLI::App                  app{ "From a segmented 3-D image of a tissue to the triangular mesh of all its cell walls.",
                "TissueTessellation" };
  app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
  options.method = ChoosePreset(found, ReconstructionParameters(), ReconstructionParameters::PaperPreset());
  AddInputOptions(app, found, options);
  AddOutputOptions(app, options.outputs);
  AddProjectionOptions(app, options.projection);
  AddImageOptions(app, options.image);
  AddEvaluationOptions(app, options.evaluation);
  AddMethodOptions(app, options.method);
  AddRunOptions(app, options.run);
  AddStrictOption(app, options.run);
  AddSlicerOptions(app,
                   MakeReconstructionModule("Tissue Tessellation",
                                            { { "labels", SlicerUse::Image }, { MembraneOption, SlicerUse::LeftOut } }),
                   options.outputs.returnParameters);
  if (!Parse(app, argc, argv))
  {
    return std::nullopt;
  }
  const CLI::Option * const closeGaps = app.get_option("--closeGaps");
  options.image.closeGaps = *closeGaps ? std::optional<double>(closeGaps->as<double>()) : std::nullopt;
  options.method.parameters.keepStages = !options.evaluation.against.empty();
  options.membrane.image = options.image.input;
  options.evaluation.image = options.image.input.ForFurther();
  options.projection.image = options.image.input;
  RequireInRange(options.method.parameters);
  return options;
}

nlohmann::ordered_json
ToJson(const TissueTessellationOptions & options)
{
  const LabelImageOptions & image = options.image;
  nlohmann::ordered_json    json;
  json["preset"] = options.method.preset;
  AddToJson(image.exterior, json);
  AddToJson(image.input, json);
  json["closeGaps"] = image.closeGaps ? nlohmann::ordered_json(*image.closeGaps) : "off";
  json["acceptSpecks"] = image.acceptsSpecks;
  json["evaluateAgainst"] = options.evaluation.against;
  json["evaluateByLabel"] = options.evaluation.byLabel;
  AddToJson(options.membrane, json);
  AddToJson(options.projection, json);
  AddToJson(options.method.parameters, json);
  return json;
}
} // namespace tissue
