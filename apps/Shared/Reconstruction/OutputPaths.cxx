/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/OutputPaths.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Pictures/PictureObstacle.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace tissue
{
std::vector<OutputPaths::Output>
OutputPaths::List() const
{
  std::vector<Output> outputs{ { walls, "cell walls" },
                               { complex, "adjacency complex" },
                               { cells, "cells" },
                               { statistics, "statistics of the cells" },
                               { wallStatistics, "statistics of the walls" },
                               { graph, "graph of neighbours" },
                               { junctions, "junctions" },
                               { report, "report" },
                               { picture, "picture" } };
  const auto          isUnasked = [](const Output & output) { return output.path.empty(); };
  outputs.erase(std::remove_if(outputs.begin(), outputs.end(), isUnasked), outputs.end());
  return outputs;
}

void
AddOutputOptions(CLI::App & app, OutputPaths & paths)
{
  app.add_option("walls", paths.walls, "The mesh of the cell walls to write")
    ->required()
    ->type_name("FILE")
    ->check(EndsIn(".vtp"));
  const auto add = [&app](const char * name, std::string & path, const char * extension, const char * description) {
    app.add_option(name, path, description)->type_name("FILE")->check(EndsIn(extension))->group("Further outputs");
  };
  add("--complex", paths.complex, ".vtu", "The adjacency complex");
  add("--cells", paths.cells, ".vtu", "The cells as polyhedra, with their statistics");
  add("--statistics", paths.statistics, ".csv", "The cells' statistics, one row a cell");
  add("--walls", paths.wallStatistics, ".csv", "The walls' statistics, one row a wall");
  add("--graph",
      paths.graph,
      ".graphml",
      "Which cells are neighbours: a node a cell with its statistics, an edge by the area of two cells' walls");
  add("--junctions", paths.junctions, ".csv", "The places in the image where four cells meet, one row each");
  add("--report", paths.report, ".json", "Report of the run");
  add("--picture", paths.picture, ".png", "Picture of the tissue; needs an X display, such as xvfb-run gives");
}

void
RequireOutputs(const OutputPaths & paths, const std::vector<std::string> & inputs)
{
  namespace fs = std::filesystem;
  std::set<fs::path> known;
  for (const auto & [path, content] : paths.List())
  {
    OutputFiles::RequireWritable(path);
    for (const std::string & input : inputs)
    {
      if (!input.empty())
      {
        OutputFiles::RequireNotInput(path, input);
      }
    }
    if (!known.insert(fs::weakly_canonical(fs::absolute(path))).second)
    {
      throw std::runtime_error("Cannot write the " + content + " to '" + path + "': another output has the same name");
    }
  }
  const std::string obstacle = paths.picture.empty() ? std::string() : FindPictureObstacle();
  if (!obstacle.empty())
  {
    throw std::runtime_error("--picture: " + obstacle);
  }
}
} // namespace tissue
