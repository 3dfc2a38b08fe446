/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Measures the phases of the pipeline on synthetic tissues of growing size, with the default parameters. Cells have as
// many voxels as make their adjacencies as hard as those of real tissue, as this is what the time of the optimization
// depends on. Times of small tissues are the mean of several, as one may be easier than others.
#include "Adjacency/ReferenceAdjacency.h"
#include "Complex/AdjacencyComplex.h"
#include "Complex/DelaunayTetrahedralization.h"
#include "Geometry/SpatialOrder.h"
#include "LabelInput.h"
#include "Optimization/TopologyOptimizer.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Complex/SurfaceCleanUp.h"
#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkLabelImageToCellWallMeshFilter.h"
#include "itkLabelJunctionExtractionFilter.h"
#include "itkSyntheticTissueImageSource.h"

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>
#include <itkMultiThreaderBase.h>

#include <cmath>
#include <iostream>
#include <map>
#include <string>

namespace
{
using namespace tissue;

LabelImage::Pointer
MakeTissue(std::int64_t numberOfCells, std::uint64_t seed = 1)
{
  constexpr double voxelsPerCell = 4000.0; // Adjacencies then are about as hard as those of real tissue.
  using SourceType = itk::SyntheticTissueImageSource<LabelImage>;
  constexpr unsigned int margin = 2; // In voxels: all cells at the surface have the exterior beside them.
  const double           side = std::cbrt(voxelsPerCell * static_cast<double>(numberOfCells)) + 2 * margin;
  LabelImage::SizeType   size;
  size.Fill(static_cast<itk::SizeValueType>(side));
  const auto source = SourceType::New();
  source->SetSize(size);
  source->SetNumberOfCells(static_cast<std::uint32_t>(numberOfCells));
  source->SetShape(SourceType::ShapeEnum::Block);
  source->SetMargin(margin);
  source->SetSmoothing(1);
  source->SetSeed(seed);
  source->Update();
  return source->GetOutput();
}

/** \brief The input of the optimization, its vertices in spatial order as in ReconstructTissue(). */
struct Tissue
{
  std::vector<Point>       centers;
  ReferenceAdjacency       reference;
  AdjacencyComplex         cleaned;
  ReconstructionParameters parameters;

  explicit Tissue(const JunctionSet & junctions)
    : Tissue(junctions, SpatialOrder(ListCenters(junctions)))
  {}

private:
  Tissue(const JunctionSet & junctions, const std::vector<VertexId> & order)
    : reference(ReferenceAdjacency(junctions).Renumbered(RanksInOrder(order)))
    , cleaned(0, {})
  {
    for (const VertexId v : order)
    {
      centers.push_back(junctions.cells[v].center);
    }
    cleaned = AdjacencyComplex(static_cast<VertexId>(centers.size()), DelaunayTetrahedralization(centers));
    SurfaceCleanUpParameters cleanUp;
    cleanUp.maximumEdgeLength = parameters.maximumEdgeLengthFactor * MedianNeighborDistance(junctions);
    CleanSurface(cleaned, centers, cleanUp);
  }

  static std::vector<Point>
  ListCenters(const JunctionSet & junctions)
  {
    std::vector<Point> centers;
    for (const Cell & cell : junctions.cells)
    {
      centers.push_back(cell.center);
    }
    return centers;
  }
};

std::vector<Tissue>
MakeTissues(std::int64_t numberOfCells)
{
  constexpr std::int64_t cellsOfAll = 10000; // So many cells in all tissues of one size even out easy ones.
  std::vector<Tissue>    tissues;
  do
  {
    const auto extraction = ExtractTissue(MakeTissue(numberOfCells, tissues.size() + 1));
    tissues.emplace_back(extraction->GetOutput()->GetJunctionSet());
  } while (static_cast<std::int64_t>(tissues.size() + 1) * numberOfCells <= cellsOfAll);
  return tissues;
}

void
ExtractionOfJunctions(benchmark::State & state, const LabelImage * labels)
{
  const auto numberOfThreads = static_cast<itk::ThreadIdType>(state.range(0));
  const auto extraction = itk::LabelJunctionExtractionFilter<LabelImage>::New();
  extraction->SetInput(labels);
  extraction->SetNumberOfWorkUnits(numberOfThreads);
  extraction->GetMultiThreader()->SetMaximumNumberOfThreads(numberOfThreads);
  for (auto _ : state)
  {
    extraction->Modified();
    extraction->Update();
  }
  const auto numberOfVoxels = static_cast<double>(labels->GetBufferedRegion().GetNumberOfPixels());
  // The rate is by processor time, so that it is that of one thread, however many there are and whoever else is at
  // work.
  state.counters["voxels/s/thread"] = benchmark::Counter(numberOfVoxels, benchmark::Counter::kIsIterationInvariantRate);
}

void
Delaunay(benchmark::State & state)
{
  const std::vector<Tissue> tissues = MakeTissues(state.range(0));
  for (auto _ : state)
  {
    Stopwatch stopwatch;
    for (const Tissue & tissue : tissues)
    {
      benchmark::DoNotOptimize(DelaunayTetrahedralization(tissue.centers));
    }
    state.SetIterationTime(stopwatch.Lap().processorSeconds / static_cast<double>(tissues.size()));
  }
  state.SetComplexityN(state.range(0));
}

void
Optimization(benchmark::State & state)
{
  const std::vector<Tissue> tissues = MakeTissues(state.range(0));
  double                    adjacency4 = 0.0;
  for (auto _ : state)
  {
    double seconds = 0.0;
    adjacency4 = 0.0;
    for (const Tissue & tissue : tissues)
    {
      AdjacencyComplex complex = tissue.cleaned;
      Stopwatch        stopwatch;
      TopologyOptimizer(
        complex, tissue.centers, &tissue.reference, tissue.parameters.energy, tissue.parameters.annealing)
        .Run();
      seconds += stopwatch.Lap().processorSeconds;
      adjacency4 += ComputeAdjacencyOverlap(AdjacencyTuples::Of(complex.GetTetrahedra()), tissue.reference).adjacency4;
    }
    state.SetIterationTime(seconds / static_cast<double>(tissues.size()));
  }
  state.counters["adjacency4"] = adjacency4 / static_cast<double>(tissues.size());
  state.SetComplexityN(state.range(0));
}

/** Measures the time of the fit by the clock, on all processors. */
void
FittingOfWalls(benchmark::State & state)
{
  const auto reconstruction = itk::LabelImageToCellWallMeshFilter<LabelImage>::New();
  reconstruction->SetInput(MakeTissue(state.range(0)));
  for (auto _ : state)
  {
    reconstruction->Modified();
    reconstruction->Update();
    state.SetIterationTime(reconstruction->GetOutput()->GetReconstruction().dualSeconds);
  }
  state.SetComplexityN(state.range(0));
}

struct Options
{
  std::string  labels;
  std::int64_t mostCells = 20000;
};

void
Register(const Options & options, const LabelImage * labels)
{
  benchmark::RegisterBenchmark("ExtractionOfJunctions", ExtractionOfJunctions, labels)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
  const std::map<std::string, void (*)(benchmark::State &)> phases = { { "Delaunay", Delaunay },
                                                                       { "FittingOfWalls", FittingOfWalls },
                                                                       { "Optimization", Optimization } };
  for (const auto & [name, phase] : phases)
  {
    auto * const family = benchmark::RegisterBenchmark(name.c_str(), phase);
    for (const std::int64_t n : { 1000, 2000, 5000, 10000, 20000, 50000, 100000 })
    {
      if (n <= options.mostCells)
      {
        family->Arg(n);
      }
    }
    family->ArgName("cells")->UseManualTime()->Complexity(benchmark::oAuto)->Unit(benchmark::kMillisecond);
  }
}
} // namespace

int
main(int argc, char ** argv)
{
  benchmark::Initialize(&argc, argv);
  Options  options;
  CLI::App app("Times of the phases of the pipeline; takes the options of Google Benchmark (--benchmark_...), too");
  app.option_defaults()->always_capture_default();
  app.add_option("--labels", options.labels, "Extract the junctions of this image, not of a synthetic one")
    ->check(CLI::ExistingFile);
  app.add_option("--mostCells", options.mostCells, "Cells of the largest tissue")->check(CLI::Range(1000, 100000));
  CLI11_PARSE(app, argc, argv);
  try
  {
    const auto labels = options.labels.empty() ? MakeTissue(1000) : ReadLabels(options.labels);
    Register(options, labels);
    benchmark::RunSpecifiedBenchmarks();
  }
  catch (const std::exception & error)
  {
    std::cerr << "PipelineBenchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
