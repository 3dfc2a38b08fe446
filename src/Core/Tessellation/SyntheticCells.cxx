/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Tessellation/SyntheticCells.h"

#include "Tessellation/CellMoments.h"
#include "TissueTessellationCore/Common/Random.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace tissue
{
namespace
{
using SeedId = AnisotropicTessellation::SeedId;

/** The sweeps of relaxation of the founders. They are enough for even founders; more would only make these more alike.
 */
constexpr int numberOfFounderSweeps = 8;
/** The most sweeps to give every cell a sample. One is nearly always enough. */
constexpr int numberOfRepairSweeps = 50;
/** The number of random directions of which a cell divides across the longest. With three the wall takes about the
 * shortest way, but never quite. */
constexpr int numberOfDirections = 3;

double
DrawBetween(double lower, double upper, Random & random)
{
  return lower + (upper - lower) * random.Uniform();
}

/** Draws a unit vector, uniformly on the sphere: the direction of a point in the unit ball, but not too near 0. */
Point
DrawDirection(Random & random)
{
  for (;;)
  {
    const double x = DrawBetween(-1.0, 1.0, random);
    const double y = DrawBetween(-1.0, 1.0, random);
    const double z = DrawBetween(-1.0, 1.0, random);
    const Point  vector = { { x, y, z } };
    const double squaredNorm = Dot(vector, vector);
    if (squaredNorm <= 1.0 && squaredNorm > 1e-4)
    {
      return Normalized(vector);
    }
  }
}

/** Draws a metric whose unit ball has axes of lengths a, 1 and 1 / a in random directions, times a random size. The
 * ratio a * a of the longest to the shortest is at most the anisotropy. */
Metric
DrawMetric(double anisotropy, Random & random)
{
  const double                size = DrawBetween(0.85, 1.15, random);
  const double                longest = DrawBetween(1.0, std::sqrt(anisotropy), random);
  const Point                 first = DrawDirection(random);
  const Point                 second = Normalized(Cross(first, DrawDirection(random)));
  const Point                 axes[] = { first, second, Cross(first, second) };
  const std::array<double, 3> lengths = { { size * longest, size, size / longest } };
  Metric                      metric = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
  for (std::size_t k = 0; k < 3; ++k)
  {
    std::size_t entry = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = i; j < 3; ++j)
      {
        metric[entry++] += axes[k][i] * axes[k][j] / (lengths[k] * lengths[k]);
      }
    }
  }
  return metric;
}

/** \brief The tissue while it grows: a seed for each cell, and the samples' cells when they were last assigned. */
class GrowingTissue
{
public:
  GrowingTissue(const TissueSamples & samples, const SyntheticCellOptions & options);

  /** Does one sweep of Lloyd's relaxation. */
  void
  RelaxFounders();
  /** Divides as many cells as needed, at most all, and lets all round off. */
  void
  DivideCells();
  /** Gives the tessellation, once every cell has a sample. */
  AnisotropicTessellation
  Finish();

private:
  std::vector<CellMoments>
  MeasureCells() const
  {
    return tissue::MeasureCells(m_Samples.points, m_CellOfSample, m_Seeds.size(), m_Samples.boxSize);
  }
  std::vector<std::size_t>
  ChooseMothers(const std::vector<CellMoments> & cells);
  void
  DrawPlane(const CellMoments & cell, Point & normal, double & offset);
  /** Moves every seed to its cell's centroid, and adapts its metric to the cell's shape. */
  void
  CenterSeeds(bool adaptMetrics);
  /** Moves seeds without a sample into other cells. Returns whether there were any. */
  bool
  ReplantEmptyCells();

  const TissueSamples &        m_Samples;
  const SyntheticCellOptions & m_Options;
  Random                       m_Random;
  std::vector<MetricSeed>      m_Seeds;
  std::vector<SeedId>          m_CellOfSample;
};

GrowingTissue::GrowingTissue(const TissueSamples & samples, const SyntheticCellOptions & options)
  : m_Samples(samples)
  , m_Options(options)
  , m_Random(options.seed)
  , m_Seeds(static_cast<std::size_t>(options.numberOfFounders))
  , m_CellOfSample(samples.points.size())
{
  // The first samples of a shuffle are distinct.
  std::vector<std::size_t> order(samples.points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  for (std::size_t i = 0; i < m_Seeds.size(); ++i)
  {
    std::swap(order[i], order[i + m_Random.Index(order.size() - i)]);
    m_Seeds[i].position = samples.points[order[i]];
    if (options.anisotropy > 1.0)
    {
      m_Seeds[i].metric = DrawMetric(options.anisotropy, m_Random);
    }
  }
}

void
GrowingTissue::CenterSeeds(bool adaptMetrics)
{
  const std::vector<CellMoments> cells = this->MeasureCells();
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (cells[i].numberOfPoints > 0)
    {
      m_Seeds[i].position = cells[i].mean;
      if (adaptMetrics)
      {
        // By this metric all cells, long or flat, large or small, reach equally far in all directions.
        m_Seeds[i].metric = Inverse(cells[i].covariance);
      }
    }
  }
  this->ReplantEmptyCells();
}

bool
GrowingTissue::ReplantEmptyCells()
{
  std::vector<bool> isEmpty(m_Seeds.size(), true);
  for (const SeedId cell : m_CellOfSample)
  {
    isEmpty[static_cast<std::size_t>(cell)] = false;
  }
  bool anyEmpty = false;
  for (std::size_t i = 0; i < m_Seeds.size(); ++i)
  {
    if (isEmpty[i])
    {
      const std::size_t sample = m_Random.Index(m_CellOfSample.size());
      m_Seeds[i].position = m_Samples.points[sample];
      m_Seeds[i].metric = m_Seeds[static_cast<std::size_t>(m_CellOfSample[sample])].metric;
      anyEmpty = true;
    }
  }
  return anyEmpty;
}

void
GrowingTissue::RelaxFounders()
{
  m_CellOfSample = AssignSamples(AnisotropicTessellation(m_Seeds), m_Samples);
  this->CenterSeeds(false);
}

/** Chooses the largest cells, their sizes varied by up to 30 % for the chance of their growth. */
std::vector<std::size_t>
GrowingTissue::ChooseMothers(const std::vector<CellMoments> & cells)
{
  std::vector<std::pair<double, std::size_t>> sizes;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    sizes.emplace_back(-DrawBetween(0.7, 1.3, m_Random) * static_cast<double>(cells[i].numberOfPoints), i);
  }
  std::sort(sizes.begin(), sizes.end());
  sizes.resize(std::min(sizes.size(), static_cast<std::size_t>(m_Options.numberOfCells) - sizes.size()));
  std::vector<std::size_t> mothers;
  for (const auto & sizeAndCell : sizes)
  {
    mothers.push_back(sizeAndCell.second);
  }
  return mothers;
}

/** Draws the plane by which a cell divides: near its centroid, by up to a fifth of its deviation there, and across the
 * longest of some random directions. */
void
GrowingTissue::DrawPlane(const CellMoments & cell, Point & normal, double & offset)
{
  double greatest = 0.0;
  for (int i = 0; i < numberOfDirections; ++i)
  {
    const Point  direction = DrawDirection(m_Random);
    const double variance = QuadraticForm(cell.covariance, direction);
    if (variance > greatest)
    {
      greatest = variance;
      normal = direction;
    }
  }
  offset = Dot(normal, cell.mean) + DrawBetween(-0.2, 0.2, m_Random) * std::sqrt(greatest);
}

void
GrowingTissue::DivideCells()
{
  struct Division
  {
    SeedId daughter = -1;
    Point  normal;
    double offset;
  };
  m_CellOfSample = AssignSamples(AnisotropicTessellation(m_Seeds), m_Samples);
  const std::vector<CellMoments> cells = this->MeasureCells();
  std::vector<Division>          divisions(cells.size());
  for (const std::size_t mother : this->ChooseMothers(cells))
  {
    Division & division = divisions[mother];
    division.daughter = static_cast<SeedId>(m_Seeds.size());
    this->DrawPlane(cells[mother], division.normal, division.offset);
    m_Seeds.emplace_back();
  }
  for (std::size_t i = 0; i < m_CellOfSample.size(); ++i)
  {
    const Division & division = divisions[static_cast<std::size_t>(m_CellOfSample[i])];
    if (division.daughter >= 0 && Dot(division.normal, m_Samples.points[i]) > division.offset)
    {
      m_CellOfSample[i] = division.daughter;
    }
  }
  this->CenterSeeds(true);
}

AnisotropicTessellation
GrowingTissue::Finish()
{
  for (int sweep = 0; sweep < numberOfRepairSweeps; ++sweep)
  {
    AnisotropicTessellation tessellation(m_Seeds);
    m_CellOfSample = AssignSamples(tessellation, m_Samples);
    if (!this->ReplantEmptyCells())
    {
      return tessellation;
    }
  }
  throw std::runtime_error(std::to_string(m_Options.numberOfCells) + " cells: no arrangement was found in which " +
                           "each of them has one of the tissue's " + std::to_string(m_Samples.points.size()) +
                           " sample points");
}
} // namespace

AnisotropicTessellation
GrowSyntheticCells(const TissueSamples & samples, const SyntheticCellOptions & options, const Execution & execution)
{
  const auto numberOfCells = static_cast<std::size_t>(options.numberOfCells);
  if (samples.points.size() < numberOfCells)
  {
    throw std::runtime_error(std::to_string(numberOfCells) + " cells are too many for the tissue's " +
                             std::to_string(samples.points.size()) + " sample points");
  }
  int numberOfSteps = numberOfFounderSweeps;
  for (std::int64_t count = options.numberOfFounders; count < options.numberOfCells; count *= 2)
  {
    ++numberOfSteps;
  }
  GrowingTissue tissue(samples, options);
  for (int step = 0; step < numberOfSteps; ++step)
  {
    execution.Report(static_cast<double>(step) / numberOfSteps);
    if (step < numberOfFounderSweeps)
    {
      tissue.RelaxFounders();
    }
    else
    {
      tissue.DivideCells();
    }
  }
  return tissue.Finish();
}
} // namespace tissue
