/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/OutputPaths.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/Exports/MeshExport.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Pictures/PictureObstacle.h"
#include "Shared/Projection/CellColumnNames.h"
#include "Shared/Simulation/SimulationModel.h"

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
                               { cellSurfaces, "surfaces of the cells" },
                               { statistics, "statistics of the cells" },
                               { wallStatistics, "statistics of the walls" },
                               { graph, "graph of neighbours" },
                               { junctions, "junctions" },
                               { report, "report" },
                               { picture, "picture" },
                               { page, "page" },
                               { returnParameters, "results for 3D Slicer" } };
  for (const std::string & simulation : simulations)
  {
    outputs.push_back({ simulation, "model for a simulation" });
    if (IsGmshModel(simulation))
    {
      outputs.push_back({ GmshWallsBeside(simulation), "walls of the model" });
    }
  }
  for (const std::string & path : exports)
  {
    outputs.push_back({ path, "mesh" });
  }
  const auto isUnasked = [](const Output & output) { return output.path.empty(); };
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
  const auto add = [&app](const char *                     name,
                          std::string &                    path,
                          const std::vector<std::string> & extensions,
                          const char *                     description) {
    app.add_option(name, path, description)->type_name("FILE")->check(EndsIn(extensions))->group("Further outputs");
  };
  add("--complex", paths.complex, { ".vtu" }, "The adjacency complex");
  add("--cells",
      paths.cells,
      { ".vtu", ".vtm" },
      "The cells as polyhedra, with their statistics, or (.seg.vtm) as a segmentation of 3D Slicer");
  add("--cellSurfaces",
      paths.cellSurfaces,
      { ".vtp" },
      "The closed surface of each cell, walls twice, with its statistics");
  app
    .add_option("--simulation",
                paths.simulations,
                "A model to mesh the cells: .geo for Gmsh (with a .msh beside it), .smesh for TetGen; may be repeated")
    ->type_name("FILE")
    ->check(EndsIn(std::vector<std::string>{ ".geo", ".smesh" }))
    ->group("Further outputs");
  app
    .add_option(
      "--export",
      paths.exports,
      "The cells for other programs: .ply (cellcomplex), .mgx.ply (MorphoGraphX), .glb, .obj, .stl; may be repeated")
    ->type_name("FILE")
    ->check(EndsIn(std::vector<std::string>{ ".ply", ".glb", ".obj", ".stl" }))
    ->group("Further outputs");
  app.add_option("--exportCells", paths.exportedCells, "Labels of the cells in them; all by default")
    ->type_name("LABELS")
    ->group("Further outputs");
  add("--statistics", paths.statistics, { ".csv" }, "The cells' statistics, one row a cell");
  // A module of Slicer needs another name than that of the mesh.
  add("--wallStatistics,--walls", paths.wallStatistics, { ".csv" }, "The walls' statistics, one row a wall");
  add("--graph",
      paths.graph,
      { ".graphml" },
      "Which cells are neighbours: a node a cell with its statistics, an edge by the area of two cells' walls");
  add("--junctions", paths.junctions, { ".csv" }, "The places in the image where four cells meet, one row each");
  add("--report", paths.report, { ".json" }, "Report of the run");
  add("--page", paths.page, { ".html" }, "Page to look at the cells, their statistics and the report in a browser");
  add("--picture", paths.picture, { ".png" }, "Picture of the tissue, on a display or by EGL");
  app
    .add_option("--colorBy",
                paths.colorBy,
                "Column of the cells' statistics that the picture is coloured by: Layer, Volume, MeanCurvature, ...")
    ->needs("--picture")
    ->type_name("COLUMN")
    ->group("Further outputs");
}

void
RequireColumn(const OutputPaths & paths, const std::vector<std::string> & projected)
{
  std::vector<std::string> names = CellColumnNames();
  names.emplace_back("Name");
  names.insert(names.end(), projected.begin(), projected.end());
  if (paths.colorBy.empty() || std::find(names.begin(), names.end(), paths.colorBy) != names.end())
  {
    return;
  }
  std::string list;
  for (const std::string & name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  throw std::runtime_error("--colorBy: the cells have no column '" + paths.colorBy + "'; there are " + list);
}

bool
IsSegmentation(const std::string & path)
{
  return std::filesystem::path(path).extension() == ".vtm";
}

void
RequireOutputs(const OutputPaths & paths, const std::vector<std::string> & inputs)
{
  namespace fs = std::filesystem;
  std::set<fs::path> known;
  for (const auto & [path, content] : paths.List())
  {
    IsSegmentation(path) ? OutputFiles::RequireWritableWithPieces(path) : OutputFiles::RequireWritable(path);
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
