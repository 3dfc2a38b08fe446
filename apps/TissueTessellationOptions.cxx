/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationOptions.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <map>

namespace tissue
{
namespace
{
const std::map<std::string, Legality>   LegalityNames{ { "combinatorial", Legality::Combinatorial },
                                                     { "geometric", Legality::Geometric } };
const std::map<std::string, RingRule>   RingNames{ { "reference", RingRule::BestOfReference },
                                                 { "delaunay", RingRule::ProjectedDelaunay } };
const std::map<std::string, CornerRule> CornerNames{ { "image", CornerRule::ImageJunction },
                                                     { "circumcenter", CornerRule::ProjectedCircumcenter } };

template <typename TValue>
std::string
NameOf(const std::map<std::string, TValue> & names, TValue value)
{
  for (const auto & [name, named] : names)
  {
    if (named == value)
    {
      return name;
    }
  }
  return "unknown";
}

/** An option of the parameters that overrides the preset, whatever their order on the command line. */
template <typename TValue>
CLI::Option *
AddParameter(CLI::App & app, const std::string & name, TValue & value, const std::string & description)
{
  return app.add_option(name, value, description)->group("Method");
}

template <typename TValue>
void
AddNamedParameter(CLI::App & app, const std::string & name, TValue & value, const std::map<std::string, TValue> & names,
                  const std::string & description)
{
  AddParameter(app, name, value, description)->transform(CLI::CheckedTransformer(names, CLI::ignore_case));
}

void
AddFileOptions(CLI::App & app, TissueTessellationOptions & options)
{
  app.add_option("labels", options.labels, "Segmented 3-D image in any of ITK's formats")
    ->required()
    ->type_name("FILE");
  app.add_option("walls", options.walls, "The mesh of the cell walls to write (.vtp)")->required()->type_name("FILE");
  const auto add = [&app](const char * name, std::string & path, const char * description) {
    app.add_option(name, path, description)->type_name("FILE")->group("Further outputs");
  };
  add("--complex", options.complex, "The adjacency complex (.vtu)");
  add("--cells", options.cells, "The cells as polyhedra, with their statistics (.vtu)");
  add("--statistics", options.statistics, "The cells' statistics, one row a cell (.csv)");
  add("--report", options.report, "Report of the run (.json)");
  add("--picture", options.picture, "Picture of the tissue (.png); needs an X display, such as xvfb-run gives");
}

void
AddImageOptions(CLI::App & app, TissueTessellationOptions & options)
{
  const std::string group = "Image";
  app.add_option("--exteriorLabel", options.exteriorLabel, "Label of the exterior; found in the image by default")
    ->group(group);
  app.add_flag("--zeroIsCell", options.zeroIsCell, "Take label 0 for a cell")->group(group);
  app.add_option("--spacing", options.spacing, "Voxel size x y z in place of the file's")
    ->check(CLI::Range(1e-12, 1e12))
    ->group(group);
  app
    .add_option("--closeGaps",
                options.closeGaps,
                "Grow the labels over walls of background up to this width (in the image's units; 0: chosen from the "
                "image)")
    ->check(CLI::Range(0.0, 1e12))
    ->group(group);
}

void
AddMethodOptions(CLI::App & app, ReconstructionParameters & p)
{
  AddParameter(
    app, "--maximumEdgeLength", p.maximumEdgeLength, "l_max of the clean-up, in the image's units; 0: automatic");
  AddParameter(app,
               "--maximumEdgeLengthFactor",
               p.maximumEdgeLengthFactor,
               "Automatic l_max over the median distance of neighbours");
  AddParameter(app, "--guidedCleanUp", p.guidedCleanUp, "Whether the image guides the clean-up (true or false)");
  AddNamedParameter(app, "--legality", p.annealing.legality, LegalityNames, "combinatorial or geometric");
  AddNamedParameter(app, "--rings", p.annealing.ringRule, RingNames, "Triangulation of rings: reference or delaunay");
  AddParameter(app, "--maximumDegree", p.annealing.maximumDegree, "Largest degree of an edge that is removed");
  AddParameter(app, "--cycles", p.annealing.numberOfCycles, "Temperature cycles");
  AddParameter(
    app, "--initialTemperature", p.annealing.initialTemperature, "Of the first cycle, in energies of one quadruple");
  AddParameter(app, "--coolingFactor", p.annealing.coolingFactor, "Of the temperature, from cycle to cycle");
  AddParameter(app, "--adjacencyWeight", p.energy.adjacencyWeight, "Weight of the image term");
  AddParameter(app, "--neighborWeight", p.energy.neighborWeight, "Weight of the prior on the numbers of neighbours");
  AddParameter(app, "--lengthWeight", p.energy.lengthWeight, "Weight of the longest edges");
  AddNamedParameter(app, "--corners", p.corners, CornerNames, "Positions of the cells' corners: image or circumcenter");
  AddParameter(app, "--refinement", p.refinement, "Times that each triangle is split in four, 0 .. 3");
  AddParameter(app, "--smoothing", p.smoothingIterations, "Iterations of the walls' smoothing");
  AddParameter(app, "--seed", p.annealing.seed, "Seed of the annealing");
}

/** The preset must be known before the options that override it are read. */
void
ApplyPreset(int argc, char ** argv, TissueTessellationOptions & options)
{
  CLI::App app;
  app.allow_extras();
  app.set_help_flag();
  app.add_option("--preset", options.preset);
  app.parse(argc, argv);
  if (options.preset == "paper")
  {
    options.parameters = ReconstructionParameters::PaperPreset();
  }
}
} // namespace

std::vector<std::string>
TissueTessellationOptions::Outputs() const
{
  std::vector<std::string> outputs;
  for (const std::string * path : { &walls, &complex, &cells, &statistics, &report, &picture })
  {
    if (!path->empty())
    {
      outputs.push_back(*path);
    }
  }
  return outputs;
}

std::optional<TissueTessellationOptions>
ParseCommandLine(int argc, char ** argv, int & exitCode)
{
  TissueTessellationOptions options;
  CLI::App                  app{ "From a segmented 3-D image of a tissue to the triangular mesh of all its cell walls.",
                "TissueTessellation" };
  app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
  try
  {
    ApplyPreset(argc, argv, options);
    AddFileOptions(app, options);
    AddImageOptions(app, options);
    app.add_option("--preset", options.preset, "default, or paper: the method of the paper to the letter")
      ->check(CLI::IsMember({ "default", "paper" }))
      ->capture_default_str()
      ->group("Method");
    AddMethodOptions(app, options.parameters);
    app.add_option("--threads", options.threads, "Threads; 0: all cores. The result does not depend on it")
      ->check(CLI::Range(0, 1024));
    app.add_flag("--quiet", options.isQuiet, "Say nothing but warnings and errors");
    app.parse(argc, argv);
    options.parameters.Check();
  }
  catch (const CLI::Success & success)
  {
    exitCode = app.exit(success);
    return std::nullopt;
  }
  catch (const std::exception & error)
  {
    std::cerr << "TissueTessellation: " << error.what() << "\nRun with --help for the options.\n";
    exitCode = EXIT_FAILURE;
    return std::nullopt;
  }
  return options;
}

nlohmann::ordered_json
ToJson(const TissueTessellationOptions & options)
{
  const ReconstructionParameters & p = options.parameters;
  nlohmann::ordered_json           json;
  json["preset"] = options.preset;
  json["exteriorLabel"] = options.exteriorLabel ? nlohmann::ordered_json(*options.exteriorLabel) : "automatic";
  json["zeroIsCell"] = options.zeroIsCell;
  json["spacing"] = options.spacing ? nlohmann::ordered_json(*options.spacing) : "of the image";
  json["closeGaps"] = options.closeGaps ? nlohmann::ordered_json(*options.closeGaps) : "off";
  json["maximumEdgeLength"] = p.maximumEdgeLength;
  json["maximumEdgeLengthFactor"] = p.maximumEdgeLengthFactor;
  json["guidedCleanUp"] = p.guidedCleanUp;
  json["legality"] = NameOf(LegalityNames, p.annealing.legality);
  json["rings"] = NameOf(RingNames, p.annealing.ringRule);
  json["maximumDegree"] = p.annealing.maximumDegree;
  json["cycles"] = p.annealing.numberOfCycles;
  json["initialTemperature"] = p.annealing.initialTemperature;
  json["coolingFactor"] = p.annealing.coolingFactor;
  json["adjacencyWeight"] = p.energy.adjacencyWeight;
  json["neighborWeight"] = p.energy.neighborWeight;
  json["lengthWeight"] = p.energy.lengthWeight;
  json["corners"] = NameOf(CornerNames, p.corners);
  json["refinement"] = p.refinement;
  json["smoothing"] = p.smoothingIterations;
  json["seed"] = p.annealing.seed;
  return json;
}
} // namespace tissue
