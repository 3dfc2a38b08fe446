/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueVotes.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Image/BlockScan.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
constexpr std::size_t NumberOfVotes = 32;
/** Between two reports of progress. */
constexpr std::size_t VotesAtATime = 16;
/** In units of a seed's uncertainty: of the logarithm of its metric, and of the part of it that is the seed's size. */
constexpr double MetricUncertainty = 2.4;
constexpr double SizeUncertainty = 3.0;

/** A random number of mean 0 and deviation 1. */
double
Deviate(Random & random)
{
  return std::sqrt(12.0) * (random.Uniform() - 0.5);
}

/** A seed a little off, its metric drawn to that of a ball by a share of the way. */
MetricSeed
Disturbed(MetricSeed seed, double spacing, double uncertainty, double roundness, Random & random)
{
  for (double & coordinate : seed.position)
  {
    coordinate += uncertainty * spacing * Deviate(random);
  }
  Metric log = MapEigenvalues(seed.metric, [](double value) { return std::log(value); });
  for (double & entry : log)
  {
    entry = (1.0 - roundness) * entry + MetricUncertainty * uncertainty * Deviate(random);
  }
  const double size = SizeUncertainty * uncertainty * Deviate(random);
  for (const int diagonal : { 0, 3, 5 })
  {
    log[diagonal] += size;
  }
  seed.metric = MapEigenvalues(log, [](double value) { return std::exp(value); });
  return seed;
}

/** The quadruples of cells that meet, ascending. */
std::vector<VertexQuadruple>
FindQuadruples(const std::vector<Label> & labels, const TissueGrid & grid)
{
  const auto [sizeX, sizeY, sizeZ] = grid.size;
  BlockScan scan(grid.size, 1, { true, 0, false, 0 });
  for (std::int32_t z = -1; z <= sizeZ; ++z)
  {
    scan.BeginPlane();
    for (std::int32_t y = -1; y <= sizeY; ++y)
    {
      if (z >= 0 && z < sizeZ && y >= 0 && y < sizeY)
      {
        const Label * const row = labels.data() + grid.Offset(0, y, z);
        for (std::int32_t x = 0; x < sizeX; ++x)
        {
          if (x + 1 == sizeX || row[x + 1] != row[x])
          {
            scan.AddRun(row[x], x + 2);
          }
        }
      }
      scan.EndRow();
    }
  }
  std::vector<VertexQuadruple> quadruples;
  for (const BlockScan::Quadruple & found : scan.GetQuadruples())
  {
    VertexQuadruple cells = found.cells;
    for (VertexId & cell : cells)
    {
      cell = cell == ExteriorVertex ? ExteriorVertex : static_cast<VertexId>(scan.GetLabels().GetLabels()[cell]);
    }
    std::sort(cells.begin(), cells.end());
    quadruples.push_back(cells);
  }
  SortUnique(quadruples);
  return quadruples;
}

std::vector<JunctionVote>
CountVotes(std::vector<VertexQuadruple> all)
{
  std::sort(all.begin(), all.end());
  std::vector<JunctionVote> votes;
  for (const VertexQuadruple & quadruple : all)
  {
    if (votes.empty() || votes.back().cells != quadruple)
    {
      votes.push_back({ quadruple, 0.0 });
    }
    votes.back().share += 1.0 / NumberOfVotes;
  }
  return votes;
}
} // namespace

std::vector<JunctionVote>
VoteOnJunctions(const std::vector<MetricSeed> & seeds, const std::vector<double> & spacings,
                const TissueSamples & samples, const TissueGrid & grid, double uncertainty, double shapeDoubt,
                const Execution & execution)
{
  std::vector<std::size_t> offsets;
  offsets.reserve(samples.points.size());
  for (const Point & point : samples.points)
  {
    offsets.push_back(grid.OffsetAt(point));
  }
  std::vector<std::vector<VertexQuadruple>> found(VotesAtATime);
  std::vector<VertexQuadruple>              all;
  for (std::size_t done = 0; done < NumberOfVotes; done += VotesAtATime)
  {
    execution.For(VotesAtATime, [&](std::size_t i) {
      Random                  random(done + i);
      const double            roundness = shapeDoubt * static_cast<double>(done + i) / (NumberOfVotes - 1);
      std::vector<MetricSeed> disturbed;
      for (std::size_t k = 0; k < seeds.size(); ++k)
      {
        disturbed.push_back(Disturbed(seeds[k], spacings[k], uncertainty, roundness, random));
      }
      const auto         cells = AssignSamples(AnisotropicTessellation(std::move(disturbed)), samples);
      std::vector<Label> labels(grid.NumberOfPoints(), 0);
      for (std::size_t k = 0; k < cells.size(); ++k)
      {
        labels[offsets[k]] = cells[k] + 1;
      }
      found[i] = FindQuadruples(labels, grid);
    });
    for (const auto & quadruples : found)
    {
      all.insert(all.end(), quadruples.begin(), quadruples.end());
    }
    execution.Report(static_cast<double>(done + VotesAtATime) / NumberOfVotes);
  }
  return CountVotes(std::move(all));
}
} // namespace tissue
