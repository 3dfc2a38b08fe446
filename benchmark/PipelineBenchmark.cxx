/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The phases of the pipeline on synthetic tissues of growing size, with the default parameters. Cells are of the number
// of voxels that adjacencies are as hard there as on real tissue: how long the optimization takes depends on it.
#include "LabelInput.h"
#include "TissueTessellationCore/DelaunayTetrahedralization.h"
#include "TissueTessellationCore/DualMesh.h"
#include "TissueTessellationCore/ReconstructionParameters.h"
#include "TissueTessellationCore/SurfaceCleanUp.h"
#include "TissueTessellationCore/WallRefinement.h"
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
MakeTissue(std::int64_t numberOfCells)
{
  constexpr double voxelsPerCell = 4000.0;
  using SourceType = itk::SyntheticTissueImageSource<LabelImage>;
  constexpr unsigned int margin = 2;
  const double           side = std::cbrt(voxelsPerCell * static_cast<double>(numberOfCells)) + 2 * margin;
  LabelImage::SizeType   size;
  size.Fill(static_cast<itk::SizeValueType>(side));
  const auto source = SourceType::New();
  source->SetSize(size);
  source->SetNumberOfCells(static_cast<std::uint32_t>(numberOfCells));
  source->SetShape(SourceType::ShapeEnum::Block);
  source->SetMargin(margin);
  source->SetSmoothing(1);
  source->SetSeed(1);
  source->Update();
  return source->GetOutput();
}

/** What the phases after the extraction start from: the same for all of them, and made once. */
struct Tissue
{
  itk::TissueJunctions::Pointer extracted;
  std::vector<Point>            centers;
  ReconstructionParameters      parameters;

  explicit Tissue(std::int64_t numberOfCells)
    : extracted(ExtractJunctions(MakeTissue(numberOfCells)))
  {
    for (const Cell & cell : this->Junctions().cells)
    {
      centers.push_back(cell.center);
    }
  }

  const JunctionSet &
  Junctions() const
  {
    return extracted->GetJunctionSet();
  }

  AdjacencyComplex
  MakeDelaunay() const
  {
    return AdjacencyComplex(static_cast<VertexId>(centers.size()), DelaunayTetrahedralization(centers));
  }

  void
  Clean(AdjacencyComplex & complex, const ReferenceAdjacency & reference) const
  {
    SurfaceCleanUpParameters cleanUp;
    cleanUp.maximumEdgeLength = parameters.maximumEdgeLengthFactor * MedianNeighborDistance(this->Junctions());
    cleanUp.guidedByReference = parameters.guidedCleanUp;
    CleanSurface(complex, centers, &reference, cleanUp);
  }

  void
  Optimize(AdjacencyComplex & complex, const ReferenceAdjacency & reference) const
  {
    TopologyOptimizer(complex, centers, &reference, parameters.energy, parameters.annealing).Run();
  }
};

const Tissue &
GetTissue(std::int64_t numberOfCells)
{
  static std::map<std::int64_t, Tissue> tissues;
  const auto                            found = tissues.find(numberOfCells);
  return found != tissues.end() ? found->second : tissues.emplace(numberOfCells, Tissue(numberOfCells)).first->second;
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
  // Of processor time, so that it is a rate a thread however many there are, and whoever else is at work.
  state.counters["voxels/s/thread"] = benchmark::Counter(numberOfVoxels, benchmark::Counter::kIsIterationInvariantRate);
}

void
Delaunay(benchmark::State & state)
{
  const Tissue & tissue = GetTissue(state.range(0));
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(tissue.MakeDelaunay());
  }
  state.SetComplexityN(state.range(0));
}

void
Optimization(benchmark::State & state)
{
  const Tissue &           tissue = GetTissue(state.range(0));
  const ReferenceAdjacency reference(tissue.Junctions());
  AdjacencyComplex         cleaned = tissue.MakeDelaunay();
  tissue.Clean(cleaned, reference);
  double adjacency4 = 0.0;
  for (auto _ : state)
  {
    AdjacencyComplex complex = cleaned;
    tissue.Optimize(complex, reference);
    state.PauseTiming();
    adjacency4 = ComputeAdjacencyOverlap(complex, reference).adjacency4;
    state.ResumeTiming();
  }
  state.counters["adjacency4"] = adjacency4;
  state.SetComplexityN(state.range(0));
}

void
Dual(benchmark::State & state)
{
  const Tissue &         tissue = GetTissue(state.range(0));
  const AdjacencyComplex complex = tissue.MakeDelaunay();
  for (auto _ : state)
  {
    WallMesh walls =
      TriangulateAsStars(Dualize(complex, ComputeCorners(complex, tissue.Junctions(), tissue.parameters.corners)));
    for (int level = 0; level < tissue.parameters.refinement; ++level)
    {
      SplitTriangles(walls);
    }
    SmoothWalls(walls, tissue.parameters.smoothingIterations);
    benchmark::DoNotOptimize(walls.points.data());
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
                                                                       { "Dual", Dual },
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
    family->ArgName("cells")->Complexity(benchmark::oAuto)->Unit(benchmark::kMillisecond);
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
  app.add_option("--mostCells", options.mostCells, "Largest tissue that is optimized")->check(CLI::Range(1000, 100000));
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
