/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Runs the pipeline and its peers on the same label image in one go, and compares their times and what each mesh keeps
// of the tissue.
#include "ComparisonTable.h"
#include "LabelInput.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "TissueTessellationVTKBridge.h"
#include "itkCoreExecution.h"
#include "itkJunctionsToCellWallMeshFilter.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace
{
using namespace tissue;

struct Options
{
  std::string     labels;
  std::string     json;
  int             repetitions = 5;
  int             refinement = 1;
  double          trianglesPerCell = 0.0;
  Mesh3Parameters mesh3;
  bool            skipMesh3 = false;
  bool            skipContours = false;
};

double
Median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/** Judges a mesh as all meshes are judged: with a single exterior, as the peers know no voids. */
TissueMeshEvaluation
Evaluate(const WallMesh & walls, const JunctionSet & junctions, const LabelVolume & labels)
{
  const auto threader = itk::MultiThreaderBase::New();
  return EvaluateTissueMesh(walls, junctions, labels, itk::MakeExecution(threader));
}

/** Runs the pipeline once, from the file to VTK; `mesh` becomes what it made. */
Contestant
RunPipeline(const Options & options, itk::CellWallMesh::Pointer & mesh)
{
  Contestant run;
  Stopwatch  whole;
  Stopwatch  phase;
  const auto labels = ReadLabels(options.labels);
  run.phases.push_back({ "read", phase.Lap().wallSeconds });
  const auto extraction = ExtractTissue(labels);
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(extraction->GetOutput());
  filter->SetLabelVolume(extraction->GetLabelVolume());
  filter->SetRefinement(options.refinement);
  run.phases.push_back({ "extract", phase.Lap().wallSeconds });
  filter->Update();
  mesh = filter->GetOutput();
  const TissueReconstruction & result = mesh->GetReconstruction();
  for (const tissue::ReconstructionStage & stage : result.stages)
  {
    run.phases.push_back({ stage.name, stage.seconds });
  }
  run.phases.push_back({ "dual", result.dualSeconds });
  phase.Lap();
  const auto polyData = MakeWallPolyData(result.walls, mesh->GetJunctionSet().cells);
  run.phases.push_back({ "VTK", phase.Lap().wallSeconds });
  run.time = whole.Lap();
  run.numberOfOutputTriangles = static_cast<std::size_t>(polyData->GetNumberOfPolys());
  return run;
}

/** Runs the pipeline several times, takes the medians of the times, and judges the last mesh. */
Contestant
RunOurs(const Options & options)
{
  itk::CellWallMesh::Pointer mesh;
  std::vector<Contestant>    runs;
  for (int i = 0; i < options.repetitions; ++i)
  {
    runs.push_back(RunPipeline(options, mesh));
  }
  const auto median = [&runs](const auto & get) {
    std::vector<double> values(runs.size());
    std::transform(runs.begin(), runs.end(), values.begin(), get);
    return Median(values);
  };
  Contestant ours = runs.front();
  ours.name = "TissueTessellation";
  ours.time.wallSeconds = median([](const Contestant & run) { return run.time.wallSeconds; });
  ours.time.processorSeconds = median([](const Contestant & run) { return run.time.processorSeconds; });
  for (std::size_t p = 0; p < ours.phases.size(); ++p)
  {
    ours.phases[p].wallSeconds = median([p](const Contestant & run) { return run.phases[p].wallSeconds; });
  }
  const auto extraction = ExtractTissue(ReadLabels(options.labels));
  ours.evaluation =
    Evaluate(mesh->GetWallMesh(), mesh->GetJunctionSet(), extraction->GetLabelVolume()->GetLabelVolume());
  return ours;
}

Contestant
Judge(const std::string & name, const PeerMesh & mesh, const JunctionSet & junctions, const LabelVolume & labels)
{
  Contestant peer;
  peer.name = name;
  peer.time = mesh.time;
  peer.numberOfOutputTriangles = mesh.numberOfOutputTriangles;
  peer.evaluation = Evaluate(MakeWallMesh(mesh.boundaries), junctions, labels);
  return peer;
}

/** Guesses the first facet size: half the edge of a cube that has the volume of the mean cell. */
double
GuessFacetSize(const JunctionSet & junctions)
{
  double volume = 0.0;
  for (std::size_t v = ExteriorVertex + 1; v < junctions.cells.size(); ++v)
  {
    volume += junctions.cells[v].volume;
  }
  return 0.5 * std::cbrt(volume / static_cast<double>(junctions.cells.size() - 1));
}

/** Runs Mesh_3 so that it makes about `numberOfTriangles`. The facet size is searched in a few runs, unless it is
 * given: the number of triangles falls by the square of it. */
Contestant
RunMesh3(const Options & options, const CellImage * cells, const JunctionSet & junctions, const LabelVolume & volume,
         double numberOfTriangles)
{
  // Each run is a whole meshing, and by the square law few are needed. Numbers of triangles within 5 % of the wanted
  // one make meshes comparable.
  constexpr int    mostRuns = 5;
  constexpr double tolerance = 0.05;
  Mesh3Parameters  parameters = options.mesh3;
  const bool       isGiven = parameters.facetSize > 0.0;
  if (!isGiven)
  {
    parameters.facetSize = GuessFacetSize(junctions);
  }
  PeerMesh mesh = MeshByMesh3(cells, parameters);
  for (int run = 1; run < mostRuns && !isGiven; ++run)
  {
    const double ratio = static_cast<double>(mesh.numberOfOutputTriangles) / numberOfTriangles;
    if (std::abs(ratio - 1.0) <= tolerance)
    {
      break;
    }
    parameters.facetSize *= std::sqrt(ratio);
    mesh = MeshByMesh3(cells, parameters);
  }
  std::ostringstream name;
  name << "CGAL Mesh_3, facet size " << std::setprecision(3) << parameters.facetSize;
  return Judge(name.str(), mesh, junctions, volume);
}

std::vector<Contestant>
Compare(const Options & options)
{
  std::vector<Contestant> contestants = { RunOurs(options) };
  const auto              labels = ReadLabels(options.labels);
  const JunctionSet       junctions = ExtractTissue(labels)->GetOutput()->GetJunctionSet();
  const auto              cells = MakeCellImage(labels, junctions.cells);
  const LabelVolume       volume = MakePeerVolume(cells);
  const std::size_t       numberOfCells = junctions.cells.size() - 1;
  if (!options.skipMesh3)
  {
    const double numberOfTriangles = options.trianglesPerCell > 0.0
                                       ? options.trianglesPerCell * static_cast<double>(numberOfCells)
                                       : static_cast<double>(contestants.front().numberOfOutputTriangles);
    contestants.push_back(RunMesh3(options, cells, junctions, volume, numberOfTriangles));
  }
  if (!options.skipContours)
  {
    const auto numberOfVertices = static_cast<VertexId>(junctions.cells.size());
    contestants.push_back(Judge("vtkDiscreteMarchingCubes",
                                MeshByLabelContours(cells, numberOfVertices, LabelContour::DiscreteMarchingCubes),
                                junctions,
                                volume));
    contestants.push_back(Judge("vtkDiscreteFlyingEdges3D",
                                MeshByLabelContours(cells, numberOfVertices, LabelContour::DiscreteFlyingEdges),
                                junctions,
                                volume));
  }
  return contestants;
}

void
AddOptions(CLI::App & app, Options & options)
{
  app.option_defaults()->always_capture_default();
  app.add_option("LABELS", options.labels, "Label image")->required()->check(CLI::ExistingFile);
  app.add_option("--json", options.json, "Write the figures to this file, too");
  app.add_option("--repeat", options.repetitions, "Runs of our pipeline, whose medians are shown")
    ->check(CLI::Range(1, 1000));
  app.add_option("--refinement", options.refinement, "4-splits of our triangles")->check(CLI::Range(0, 3));
  app.add_option("--trianglesPerCell", options.trianglesPerCell, "Aim of Mesh_3; 0: as many as ours")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--facetSize", options.mesh3.facetSize, "Of Mesh_3, in the image's units; 0: searched")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--facetDistance", options.mesh3.facetDistance, "Of Mesh_3, in facet sizes")
    ->check(CLI::PositiveNumber);
  app.add_option("--cellSize", options.mesh3.cellSize, "Of Mesh_3, in facet sizes")->check(CLI::PositiveNumber);
  app.add_flag("--skipMesh3", options.skipMesh3, "Leave Mesh_3 out");
  app.add_flag("--skipContours", options.skipContours, "Leave VTK's contour filters out");
}
} // namespace

int
main(int argc, char ** argv)
{
  Options  options;
  CLI::App app("Our pipeline, CGAL Mesh_3 and VTK's discrete contours on one label image");
  AddOptions(app, options);
  CLI11_PARSE(app, argc, argv);
  try
  {
    const std::vector<Contestant> contestants = Compare(options);
    Print(contestants, std::cout);
    if (!options.json.empty())
    {
      std::ofstream file(options.json);
      file << ToJson(contestants).dump(2) << '\n';
      if (!file.flush())
      {
        throw std::runtime_error("cannot write " + options.json);
      }
    }
  }
  catch (const std::exception & error)
  {
    std::cerr << "ComparePeers: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
