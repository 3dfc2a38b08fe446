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
/** The number of tessellations that vote. The time grows with it, the steps in which a share is known become finer. */
constexpr std::size_t NumberOfVotes = 32;
/** The votes between two reports of progress. They are worked on in parallel, so there should be some for each thread.
 */
constexpr std::size_t VotesAtATime = 16;
/** The deviations of the entries of a metric's logarithm, and of what is added to its diagonal as the seed's size, in
 * units of the seed's uncertainty. The first goes with a deviation of .12 at .05 spacings. */
constexpr double MetricUncertainty = 2.4;
constexpr double SizeUncertainty = 3.0;

/** Draws a random number of mean 0 and deviation 1, uniform in its range. */
double
Deviate(Random & random)
{
  return std::sqrt(12.0) * (random.Uniform() - 0.5);
}

/** Makes a seed that is a little off, its metric drawn to that of a ball by `roundness` of the way. Metrics are
 * disturbed by their logarithms, which keeps them positive definite. */
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

/** Finds the quadruples of cells that meet in the label image, each once and in ascending order.
 *
 * The image is fed to the scan for junctions run by run, with the border that it needs around it; then the scan's
 * numbers of the cells become labels, which are vertices. */
std::vector<VertexQuadruple>
FindQuadruples(const std::vector<Label> & labels, const TissueGrid & grid)
{
  const auto [sizeX, sizeY, sizeZ] = grid.size;
  BlockScan scan(grid.size, 1, { true, 0, false });
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

/** Counts how often each quadruple comes. */
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
  // Each vote has a random generator of its own number: disturb all seeds, assign the samples to them, and list which
  // cells meet. A batch of votes is made in parallel, and gathered in their order.
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
