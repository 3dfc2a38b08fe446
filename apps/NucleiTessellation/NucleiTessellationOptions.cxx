/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/NucleiTessellationOptions.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/SlicerOptions.h"
#include "Shared/Points/PointFileReader.h"
#include "Shared/Reconstruction/ReconstructionModule.h"

#include <nlohmann/json.hpp>

namespace tissue
{
namespace
{
void
AddPointFileOptions(CLI::App & app, PointFileOptions & options)
{
  const std::string group = "Points";
  app.add_option("--columns", options.columns, "Columns of x, y and z in a table: names, or numbers from 1 on")
    ->expected(3)
    ->type_name("X Y Z")
    ->group(group);
  app
    .add_option("--frame",
                options.frame,
                "Time point that is taken of a table with several, or 'all'; of an image of nuclei, from 1 on")
    ->type_name("T")
    ->group(group);
  app.add_option("--firstLine", options.firstLine, "Line of the first point in a table, where that is not found")
    ->check(InRange(1.0, 1e9))
    ->type_name("N")
    ->group(group);
  app
    .add_option("--pointSpacing",
                options.spacing,
                "Size of a voxel, for points in voxels: what their coordinates are multiplied by")
    ->check(InRange(1e-9, 1e9))
    ->type_name("FLOAT FLOAT FLOAT")
    ->delimiter(',')
    ->group(group);
}

/** Whether the points come from a label image must be known before the files are. */
void
AddInputOptions(CLI::App & app, bool hasLabels, NucleiTessellationOptions & options)
{
  if (!hasLabels)
  {
    app
      .add_option("points",
                  options.centers.file,
                  "Centres of cells or nuclei (a table as .csv, .tsv or .txt, .fcsv, .mrk.json, .ply, .vtp), or an "
                  "image of nuclei; "
                  "none with --centersOf")
      ->required()
      ->type_name("FILE");
    AddPointFileOptions(app, options.centers.points);
  }
  const std::string group = "Points";
  app
    .add_option(
      "--centersOf", options.centers.centersOf, "Label image, in place of points: the centres of its cells are they")
    ->type_name("FILE")
    ->group(group);
  app.add_option("--box", options.centers.box, "Image that fills the box that the points were seen in; not read")
    ->type_name("FILE")
    ->group(group);
  app
    .add_flag("--dropOutliers",
              options.centers.dropsOutliers,
              "Leave out points whose fourth nearest is over ten times as far as of most; they are named")
    ->group(group);
  app.add_option("--voxelsPerCell", options.centers.voxelsPerCell, "Of the label image that is made of the points")
    ->check(InRange(50.0, 1e6))
    ->capture_default_str()
    ->group(group);
  app
    .add_option("--layer",
                options.centers.layer,
                "Whether the tissue is one layer of cells, a sheet or a shell; auto: where the points show it")
    ->check(CLI::IsMember({ "auto", "on", "off" }))
    ->type_name("{auto,on,off}")
    ->capture_default_str()
    ->group(group);
  app.add_option("--membrane", options.membrane.file, "Image of cell membranes, which is segmented from the points")
    ->type_name("FILE")
    ->group("Membranes");
  app
    .add_option("--membraneChannel",
                options.membrane.image.channel,
                "Its channel, where it is another one than --channel, which is then that of the nuclei")
    ->type_name("NUMBER")
    ->check(InRange(1, 1e6))
    ->group("Membranes");
  app
    .add_option(
      "--membraneFrame", options.membrane.image.frame, "Its frame, where the points are a table or of another frame")
    ->type_name("NUMBER")
    ->check(InRange(1, 1e6))
    ->group("Membranes");
  AddMembraneOptions(app, "--darkMembranes", options.membrane);
  // Of points, --frame is that of their table.
  hasLabels ? AddImageOptions(app, options.centers.image) : AddSpacingAndChannel(app, options.centers.image);
  AddDetectionOptions(app, options.centers.detection);
}

/** A frame of an image, which --frame gives where there is no table of points.
 * \throws std::runtime_error where it is no number from 1 on. */
unsigned int
ToImageFrame(const std::string & text)
{
  if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos ||
      std::stoul(text) == 0)
  {
    throw std::runtime_error("--frame " + text + ": of an image it is a number from 1 on");
  }
  return static_cast<unsigned int>(std::stoul(text));
}

/** How the further images are read, and that there is one at all. */
void
CompleteImageOptions(NucleiTessellationOptions & options)
{
  ImageOptions & image = options.centers.image;
  const bool     isPointFile = options.centers.centersOf.empty() && IsPointFile(options.centers.file);
  const bool     hasMembranes = !options.membrane.file.empty();
  std::string &  frame = options.centers.points.frame;
  if (!isPointFile && !frame.empty())
  {
    image.frame = ToImageFrame(frame);
    frame.clear();
  }
  if (!options.projection.signals.empty() && options.method.preset == "paper" && !hasMembranes)
  {
    throw std::runtime_error("--signal needs a label image: --preset paper makes walls of the points alone");
  }
  if (image.AreGiven() && isPointFile && !hasMembranes && options.centers.box.empty())
  {
    throw std::runtime_error("--spacing and --channel are of an image: --box gives that of the points");
  }
  const ImageOptions ofMembranes = options.membrane.image;
  options.membrane.image = isPointFile ? image : image.ForFurther();
  options.membrane.image.channel = ofMembranes.channel > 0 ? ofMembranes.channel : image.channel;
  options.membrane.image.frame = ofMembranes.frame > 0 ? ofMembranes.frame : image.frame;
  options.membrane.image.frameOption = isPointFile ? "--membraneFrame" : "--frame";
  options.evaluation.image = image.ForFurther();
  options.projection.image = image;
}

/** 3D Slicer has points as markups: options of tables, and of images in their place, make no sense there. */
SlicerModule
MakeModule()
{
  std::map<std::string, SlicerUse> uses{ { "points", SlicerUse::InputPoints },
                                         { "--box", SlicerUse::Image },
                                         { "--membrane", SlicerUse::Image } };
  for (const char * name : { "--columns", "--frame", "--firstLine", "--centersOf", DetectionGroup.c_str() })
  {
    uses.emplace(name, SlicerUse::LeftOut);
  }
  return MakeReconstructionModule("Nuclei Tessellation", uses);
}
} // namespace

std::optional<NucleiTessellationOptions>
ParseCommandLine(int argc, char ** argv)
{
  using Parameters = ReconstructionParameters;
  const std::string         membrane = "--membrane";
  const std::string         centersOf = "--centersOf";
  const FoundOptions        found = FindOptions({ PresetOption, membrane, centersOf }, argc, argv);
  NucleiTessellationOptions options;
  CLI::App app{ "From the centres of a tissue's cells or nuclei to the triangular mesh of all its cell walls.",
                "NucleiTessellation" };
  app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
  options.method = found.count(membrane) > 0 ? ChoosePreset(found, Parameters(), Parameters::PaperPreset())
                                             : ChoosePreset(found, Parameters(), Parameters::PaperPointsPreset());
  AddInputOptions(app, found.count(centersOf) > 0, options);
  AddOutputOptions(app, options.outputs);
  AddProjectionOptions(app, options.projection);
  AddEvaluationOptions(app, options.evaluation);
  AddMethodOptions(app, options.method);
  AddRunOptions(app, options.run);
  AddStrictOption(app, options.run);
  AddSlicerOptions(app, MakeModule(), options.outputs.returnParameters);
  if (!Parse(app, argc, argv))
  {
    return std::nullopt;
  }
  options.method.parameters.keepStages = !options.evaluation.against.empty();
  CompleteImageOptions(options);
  RequireInRange(options.method.parameters);
  return options;
}

nlohmann::ordered_json
ToJson(const NucleiTessellationOptions & options)
{
  const CenterOptions &  centers = options.centers;
  const bool             isPointFile = IsPointFile(centers.file);
  nlohmann::ordered_json json;
  json["preset"] = options.method.preset;
  json["points"] = !centers.centersOf.empty() ? "centres of the cells of a label image"
                   : isPointFile              ? "of the file"
                                              : "nuclei";
  if (centers.centersOf.empty() && !isPointFile)
  {
    const DetectionOptions & d = centers.detection;
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
  json["columns"] = centers.points.columns;
  json["firstLine"] = centers.points.firstLine;
  json["pointSpacing"] = centers.points.spacing ? nlohmann::ordered_json(*centers.points.spacing) : nullptr;
  json["box"] = centers.box;
  AddToJson(centers.image, json);
  if (isPointFile)
  {
    json["frame"] = centers.points.frame;
  }
  json["dropOutliers"] = centers.dropsOutliers;
  json["voxelsPerCell"] = centers.voxelsPerCell;
  json["layer"] = centers.layer;
  json["evaluateAgainst"] = options.evaluation.against;
  json["evaluateByLabel"] = options.evaluation.byLabel;
  AddToJson(options.membrane, json);
  AddToJson(options.projection, json);
  AddToJson(options.method.parameters, json);
  return json;
}
} // namespace tissue
