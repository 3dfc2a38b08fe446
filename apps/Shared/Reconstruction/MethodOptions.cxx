/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/MethodOptions.h"

#include <map>
#include <stdexcept>

namespace tissue
{
namespace
{
const std::map<std::string, Legality>   LegalityNames{ { "combinatorial", Legality::Combinatorial },
                                                     { "geometric", Legality::Geometric } };
const std::map<std::string, RingRule>   RingNames{ { "reference", RingRule::BestOfReference },
                                                 { "delaunay", RingRule::ProjectedDelaunay } };
const std::map<std::string, CornerRule> CornerNames{ { "image", CornerRule::ImageJunction },
                                                     { "lifted", CornerRule::LiftedCircumcenter },
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

/** An option of the parameters that overrides the preset, whatever their order on the command line. It has the name of
 * its parameter, which names it in errors. */
template <typename TValue>
void
AddParameter(CLI::App & app, const std::string & name, TValue & value, const std::string & description)
{
  app.add_option(name, value, description)->capture_default_str()->group("Method");
}

template <typename TValue>
void
AddNamedParameter(CLI::App & app, const std::string & name, TValue & value, const std::map<std::string, TValue> & names,
                  const std::string & description)
{
  app
    .add_option_function<std::string>(
      name, [&value, &names](const std::string & chosen) { value = names.at(chosen); }, description)
    ->check(CLI::IsMember(names))
    ->default_str(NameOf(names, value))
    ->group("Method");
}
} // namespace

void
AddOutputOptions(CLI::App & app, ReconstructionOptions & options)
{
  app.add_option("walls", options.walls, "The mesh of the cell walls to write")
    ->required()
    ->type_name("FILE")
    ->check(EndsIn(".vtp"));
  const auto add = [&app](const char * name, std::string & path, const char * extension, const char * description) {
    app.add_option(name, path, description)->type_name("FILE")->check(EndsIn(extension))->group("Further outputs");
  };
  add("--complex", options.complex, ".vtu", "The adjacency complex");
  add("--cells", options.cells, ".vtu", "The cells as polyhedra, with their statistics");
  add("--statistics", options.statistics, ".csv", "The cells' statistics, one row a cell");
  add("--junctions", options.junctions, ".csv", "The places in the image where four cells meet, one row each");
  add("--report", options.report, ".json", "Report of the run");
  add("--picture", options.picture, ".png", "Picture of the tissue; needs an X display, such as xvfb-run gives");
}

void
AddMembraneOptions(CLI::App & app, MembraneOptions & options)
{
  const std::string group = "Membranes";
  app
    .add_option("--membraneSigma",
                options.sigma,
                "Smoothing of the image of membranes before the watershed, in the image's units; 0: none")
    ->check(InRange(0.0, 1e12))
    ->capture_default_str()
    ->group(group);
}

void
AddEvaluationOption(CLI::App & app, ReconstructionOptions & options)
{
  app
    .add_option(
      "--evaluateAgainst", options.evaluateAgainst, "Label image that judges every stage of the complex, in the report")
    ->type_name("FILE")
    ->group("Further outputs");
  app
    .add_flag("--evaluateByLabel",
              options.evaluateByLabel,
              "Its cells are those of the same labels; otherwise those that hold the cells' centres")
    ->needs("--evaluateAgainst")
    ->group("Further outputs");
}

void
AddMethodOptions(CLI::App & app, ReconstructionOptions & options)
{
  app
    .add_option(
      "--preset", options.preset, "default, or paper: the method of the paper, for points with --delaunayWeight")
    ->check(CLI::IsMember({ "default", "paper" }))
    ->capture_default_str()
    ->group("Method");
  ReconstructionParameters & p = options.parameters;
  AddParameter(
    app, "--maximumEdgeLength", p.maximumEdgeLength, "l_max of the clean-up, in the image's units; 0: automatic");
  AddParameter(app,
               "--maximumEdgeLengthFactor",
               p.maximumEdgeLengthFactor,
               "Automatic l_max over the median distance of neighbours, or over the local spacing");
  AddParameter(app,
               "--localMaximumEdgeLength",
               p.localMaximumEdgeLength,
               "Whether the automatic l_max follows the local spacing of the centres (true or false)");
  AddParameter(
    app, "--separateParts", p.separateParts, "Whether parts that share no junction are apart (true or false)");
  AddParameter(
    app, "--separateVoids", p.separateVoids, "Whether enclosed voids are apart from the exterior (true or false)");
  AddParameter(app, "--guidedCleanUp", p.guidedCleanUp, "Whether the image guides the clean-up (true or false)");
  AddNamedParameter(app, "--legality", p.annealing.legality, LegalityNames, "What makes a change of the complex legal");
  AddNamedParameter(app, "--rings", p.annealing.ringRule, RingNames, "Triangulation of the rings of removed edges");
  AddParameter(app, "--maximumDegree", p.annealing.maximumDegree, "Largest degree of an edge that is removed");
  AddParameter(app, "--numberOfCycles", p.annealing.numberOfCycles, "Temperature cycles");
  AddParameter(app,
               "--initialTemperature",
               p.annealing.initialTemperature,
               "Of the first cycle, in energies of one quadruple or cell");
  AddParameter(app, "--coolingFactor", p.annealing.coolingFactor, "Of the temperature, from cycle to cycle");
  AddParameter(app, "--adjacencyWeight", p.energy.adjacencyWeight, "Weight of the image term");
  AddParameter(app, "--neighborWeight", p.energy.neighborWeight, "Weight of the prior on the numbers of neighbours");
  AddParameter(app, "--lengthWeight", p.energy.lengthWeight, "Weight of the longest edges");
  AddParameter(app,
               "--unitLength",
               p.energy.unitLength,
               "What their lengths are divided by; 0: the median local spacing of the centres");
  AddParameter(app,
               "--delaunayWeight",
               p.energy.delaunayWeight,
               "Weight of the deviation from the Delaunay tetrahedralization, which the paper has not");
  AddNamedParameter(app, "--corners", p.corners, CornerNames, "Where the cells' corners come from");
  AddParameter(app, "--triangles", p.trianglesPerCell, "Wanted triangles a cell, each counted once, 40 .. 10000");
  AddParameter(app,
               "--refinement",
               p.refinement,
               "0: the walls are stars; without a fit the times that each triangle is split in four, 0 .. 3");
  AddParameter(app, "--smoothingIterations", p.smoothingIterations, "Iterations of the walls' smoothing");
  // Above 2^53 a number of a JSON report may be read as another.
  app.add_option("--seed", p.annealing.seed, "Seed of the annealing")
    ->capture_default_str()
    ->check(InRange(0.0, 9007199254740992.0))
    ->group("Method");
}

void
AddRunOptions(CLI::App & app, ReconstructionOptions & options)
{
  app.add_option("--threads", options.threads, "Threads; 0: all cores. The result does not depend on it")
    ->check(InRange(0, 1024));
  app.add_flag("--quiet", options.isQuiet, "Say nothing but warnings and errors");
}

void
ApplyPreset(int argc, char ** argv, const ReconstructionParameters & paper, ReconstructionOptions & options)
{
  CLI::App app;
  app.allow_extras();
  app.set_help_flag();
  app.add_option("--preset", options.preset);
  app.parse(argc, argv);
  if (options.preset == "paper")
  {
    options.parameters = paper;
  }
}

bool
HasOption(const std::string & name, int argc, char ** argv)
{
  std::string value;
  CLI::App    app;
  app.allow_extras();
  app.set_help_flag();
  const CLI::Option * const option = app.add_option(name, value);
  app.parse(argc, argv);
  return option->count() > 0;
}

void
FinishParameters(ReconstructionOptions & options)
{
  options.parameters.keepStages = !options.evaluateAgainst.empty();
  try
  {
    options.parameters.Check();
  }
  catch (const std::invalid_argument & error)
  {
    throw std::runtime_error(std::string("--") + error.what());
  }
}

void
AddToJson(const ReconstructionParameters & p, nlohmann::ordered_json & json)
{
  json["maximumEdgeLength"] = p.maximumEdgeLength;
  json["maximumEdgeLengthFactor"] = p.maximumEdgeLengthFactor;
  json["localMaximumEdgeLength"] = p.localMaximumEdgeLength;
  json["separateParts"] = p.separateParts;
  json["separateVoids"] = p.separateVoids;
  json["guidedCleanUp"] = p.guidedCleanUp;
  json["legality"] = NameOf(LegalityNames, p.annealing.legality);
  json["rings"] = NameOf(RingNames, p.annealing.ringRule);
  json["maximumDegree"] = p.annealing.maximumDegree;
  json["numberOfCycles"] = p.annealing.numberOfCycles;
  json["initialTemperature"] = p.annealing.initialTemperature;
  json["coolingFactor"] = p.annealing.coolingFactor;
  json["adjacencyWeight"] = p.energy.adjacencyWeight;
  json["neighborWeight"] = p.energy.neighborWeight;
  json["lengthWeight"] = p.energy.lengthWeight;
  json["unitLength"] = p.energy.unitLength;
  json["delaunayWeight"] = p.energy.delaunayWeight;
  json["corners"] = NameOf(CornerNames, p.corners);
  json["triangles"] = p.trianglesPerCell;
  json["refinement"] = p.refinement;
  json["smoothingIterations"] = p.smoothingIterations;
  json["seed"] = p.annealing.seed;
  json["fixed"] = { { "pairWeight", p.energy.pairWeight },
                    { "leastVote", p.energy.leastVote },
                    { "epidermalNeighbors", p.energy.epidermalNeighbors },
                    { "innerNeighbors", p.energy.innerNeighbors },
                    { "focusedAnnealing", p.annealing.isFocused && p.annealing.legality == Legality::Combinatorial },
                    { "focusedRounds", p.annealing.focus.numberOfRounds },
                    { "relocationWrongShare", p.annealing.relocation.wrongShare } };
}

void
AddToJson(const MembraneOptions & options, nlohmann::ordered_json & json)
{
  if (!options.file.empty())
  {
    json["membrane"] = { { "file", options.file },
                         { "sigma", options.sigma },
                         { "markerSigma", options.markerSigma },
                         { "markerDepth", options.markerDepth } };
  }
}
} // namespace tissue
