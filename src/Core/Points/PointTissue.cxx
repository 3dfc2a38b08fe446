/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/PointTissue.h"

#include "Common/Algorithms.h"
#include "Complex/LocalSpacing.h"
#include "Geometry/NearestPoints.h"
#include "Points/PartialWalls.h"
#include "Points/TissueLayer.h"
#include "Points/TissueSurface.h"
#include "Points/TissueVotes.h"
#include "Tessellation/CentroidFit.h"
#include "TissueTessellationCore/Geometry/PointRange.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace tissue
{
namespace
{
/** The fewest voxels of the mean cell. With fewer, small cells would have next to none. */
constexpr double LeastVoxelsPerCell = 50.0;
/** The most voxels of a grid, which take some gigabytes. */
constexpr double MostVoxels = 5e8;
/** The most voxels a cell in the fit. More would make the fit no better, only the labels that come of it. */
constexpr double VoxelsPerCellOfFit = 700.0;
/** The cube of the local spacing, the mean distance of the eight nearest, over the volume of a cell in plant tissues.
 */
constexpr double CubedSpacingOfCell = 1.17;
/** How often the surface follows the seeds, and the sweeps of the fit before each time. Seeds move a part of their way
 * in a sweep, so that some are needed for them to show where the surface should be. */
constexpr int NumberOfRounds = 5;
constexpr int SweepsPerRound = 3;
/** The sweeps of the fit within the final surface. About ten are enough: many more change the adjacencies little, for
 * better or worse. */
constexpr int LastSweeps = 10;
/** The sweeps that take as long as the votes, for the progress. */
constexpr int SweepsOfVotes = 40;
/** The fewest inner cells whose shifts tell how exact the points are; with fewer, those of all cells do. */
constexpr std::size_t LeastInnerCells = 20;

/** \brief Tells how far seeds are to be drawn back to points that are not quite the centroids.
 *
 * Displaced points are no tissue's centroids, and seeds have to go farther to make them so. In units of the local
 * spacing the median shift is .105 .. .142 for exact points of real and synthetic tissues, .145 .. .185 for points that
 * are displaced by a tenth of the cells' diameter (root mean square), .197 .. .248 for a fifth. Hence seeds are free up
 * to a shift of .115 and drawn back all the way from .182 on. */
double
RelaxationOf(double shift)
{
  constexpr double shiftOfExactPoints = 0.115;
  constexpr double growth = 15.0;
  return std::clamp(growth * (shift - shiftOfExactPoints), 0.0, 1.0);
}

/** The uncertainty of the seeds' places for the votes, in units of the local spacing. It grows from .02 to .045 with
 * how far the seeds are drawn back, which tells how exact the points are. */
double
UncertaintyOf(double relaxation)
{
  constexpr double uncertaintyOfExactPoints = 0.02;
  constexpr double growth = 0.025;
  return uncertaintyOfExactPoints + growth * relaxation;
}

/** How much the cells' shapes are in doubt, by the median shift of the seeds: not at all up to .175, wholly from .215
 * on. Points displaced by a tenth of the cells' diameter still show how neighbours are drawn out alike; those displaced
 * by a fifth may as well show what is not there. */
double
ShapeDoubtOf(double shift)
{
  constexpr double shiftOfSureShapes = 0.175;
  constexpr double growth = 25.0;
  return std::clamp(growth * (shift - shiftOfSureShapes), 0.0, 1.0);
}

std::string
ToText(const Point & p)
{
  std::ostringstream text;
  text << '(' << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return text.str();
}

/** Refuses what no tissue can be made of. */
void
RefusePoints(const std::vector<Point> & points)
{
  constexpr std::size_t minimum = 4;
  if (points.size() < minimum)
  {
    throw std::invalid_argument("There are " + std::to_string(points.size()) + " points, at least " +
                                std::to_string(minimum) + " are needed");
  }
  RequirePointRange(points, [](std::size_t i) { return "point " + std::to_string(i); });
  const auto nearest = FindNearestPoints(points, 1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[nearest[i][0]] == points[i])
    {
      throw std::invalid_argument("points " + std::to_string(i) + " and " + std::to_string(nearest[i][0]) +
                                  " have the same place");
    }
  }
}

Box
BoxOf(const TissueGrid & grid)
{
  Box box{ grid.lower, grid.lower };
  for (int i = 0; i < 3; ++i)
  {
    box.upper[i] += grid.size[i] * grid.steps[i];
  }
  return box;
}

void
RefusePointsOutside(const std::vector<Point> & points, const TissueGrid & grid)
{
  const Box box = BoxOf(grid);
  if (const auto i = FindPointOutside(points, box))
  {
    throw std::invalid_argument("point " + std::to_string(*i) + " at " + ToText(points[*i]) +
                                " is outside of the box from " + ToText(box.lower) + " to " + ToText(box.upper));
  }
}

std::vector<double>
SpacingsOf(const TissueSurface & surface, std::size_t numberOfPoints)
{
  std::vector<double> spacings;
  for (std::size_t i = 0; i < numberOfPoints; ++i)
  {
    spacings.push_back(surface.Spacing(i));
  }
  return spacings;
}

std::vector<std::size_t>
OffsetsOf(const TissueSamples & samples, const TissueGrid & grid)
{
  std::vector<std::size_t> offsets;
  offsets.reserve(samples.points.size());
  for (const Point & point : samples.points)
  {
    offsets.push_back(grid.OffsetAt(point));
  }
  return offsets;
}

/** Makes the grid in which the cells are fitted. It fills the same box, with VoxelsPerCellOfFit at most. */
TissueGrid
FitGridOf(const std::vector<Point> & points, const TissueGrid & grid)
{
  const TissueGrid enough = MakePointGrid(points, BoxOf(grid), VoxelsPerCellOfFit);
  return enough.NumberOfPoints() < grid.NumberOfPoints() ? enough : grid;
}

double
MeanSpacing(const std::vector<double> & spacings)
{
  double sum = 0.0;
  for (const double spacing : spacings)
  {
    sum += spacing;
  }
  return sum / static_cast<double>(spacings.size() - 1);
}

/** Gives the median distance of the seeds of inner cells from their points, in units of the local spacing. */
double
MedianShift(const CentroidFit & fit, const std::vector<Point> & points, const TissueSurface & surface)
{
  std::vector<double> inner;
  std::vector<double> all;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double shift = Distance(fit.GetSeeds()[i].position, points[i]) / surface.Spacing(i);
    all.push_back(shift);
    if (surface.IsInner(i))
    {
      inner.push_back(shift);
    }
  }
  return Median(std::move(inner.size() >= LeastInnerCells ? inner : all));
}

/** Gives each point without a grid point the one it lies at, unless that is the only one of another cell. */
void
PlantLostCells(std::vector<std::int32_t> & labels, const TissueGrid & grid, const std::vector<Point> & points)
{
  std::vector<std::size_t> counts(points.size() + 1, 0);
  for (const std::int32_t label : labels)
  {
    ++counts[label];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (counts[i + 1] == 0)
    {
      std::int32_t & label = labels[grid.OffsetAt(points[i])];
      if (label > 0 && counts[label] == 1)
      {
        throw std::invalid_argument("points " + std::to_string(label - 1) + " and " + std::to_string(i) + " at " +
                                    ToText(points[i]) + " are nearer to each other than the grid can show");
      }
      --counts[label];
      ++counts[i + 1];
      label = static_cast<std::int32_t>(i + 1);
    }
  }
}

/** The labels of a grid's points: those of samples by the nearest seed, 0 elsewhere.
 * \param offsets of the samples' points in the grid. */
std::vector<std::int32_t>
LabelGrid(const std::vector<MetricSeed> & seeds, const TissueSamples & samples,
          const std::vector<std::size_t> & offsets, const TissueGrid & grid, const Execution & execution)
{
  const auto                cells = AssignSamples(AnisotropicTessellation(seeds), samples, execution);
  std::vector<std::int32_t> labels(grid.NumberOfPoints(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    labels[offsets[i]] = cells[i] + 1;
  }
  return labels;
}

/** Surface and cells fitted in turn. */
PointTissue
EstimateSolid(const std::vector<Point> & points, const TissueGrid & grid, const Execution & execution)
{
  // First cells and surface are fitted in turn, as if the points were exact; how far the seeds went for it then tells
  // how far they are drawn back in the last sweeps, and how unsure the votes are. Fit and votes work on a grid as
  // coarse as they need; in the end the seeds label the fine one.
  TissueSurface    surface(points, BoxOf(grid));
  CentroidFit      fit(points, surface.FindNeighbors());
  const TissueGrid fitGrid = FitGridOf(points, grid);
  TissueSamples    samples = SampleMask(surface.MakeMask(fitGrid, execution));
  constexpr double numberOfSteps = NumberOfRounds * SweepsPerRound + LastSweeps + SweepsOfVotes + 1;
  int              sweeps = 0;
  const auto       sweep = [&](double relaxation) {
    fit.Sweep(samples, relaxation, execution);
    execution.Report(++sweeps / numberOfSteps);
  };
  for (int round = 0; round < NumberOfRounds; ++round)
  {
    for (int i = 0; i < SweepsPerRound; ++i)
    {
      sweep(0.0);
    }
    surface.Follow(fit.GetSeeds());
    samples = SampleMask(surface.MakeMask(fitGrid, execution));
  }
  const double shift = MedianShift(fit, points, surface);
  const double relaxation = RelaxationOf(shift);
  for (int i = 0; i < LastSweeps; ++i)
  {
    sweep(relaxation);
  }
  PointTissue tissue;
  tissue.votes = VoteOnJunctions(fit.GetSeeds(),
                                 SpacingsOf(surface, points.size()),
                                 samples,
                                 fitGrid,
                                 UncertaintyOf(relaxation),
                                 ShapeDoubtOf(shift),
                                 execution.Part(sweeps / numberOfSteps, (sweeps + SweepsOfVotes) / numberOfSteps));
  if (fitGrid.NumberOfPoints() < grid.NumberOfPoints())
  {
    samples = SampleMask(surface.MakeMask(grid, execution));
  }
  tissue.labels = LabelGrid(fit.GetSeeds(), samples, OffsetsOf(samples, grid), grid, execution);
  PlantLostCells(tissue.labels, grid, points);
  execution.Report(1.0);
  return tissue;
}

/** The cells of a layer are the Voronoi cells of the points in its middle, drawn out across it: their centroids lie
 * where they do by the rims as well, and a fit to them adds nothing in the few real and synthetic layers tried. */
PointTissue
EstimateLayer(const TissueLayer & layer, const std::vector<Point> & points, const TissueGrid & grid,
              const Execution & execution)
{
  std::vector<MetricSeed> seeds;
  for (const Point & point : points)
  {
    seeds.push_back({ point });
  }
  TissueSamples                  samples = SampleMask(layer.MakeMask(grid, execution));
  const std::vector<std::size_t> offsets = OffsetsOf(samples, grid);
  execution.Report(0.5);
  samples = layer.Flatten(std::move(samples), execution);
  execution.Report(0.9);
  PointTissue tissue;
  tissue.labels = LabelGrid(seeds, samples, offsets, grid, execution);
  RemovePartialWalls(
    tissue.labels, grid, 0.5 * layer.Thickness() / *std::max_element(grid.steps.begin(), grid.steps.end()));
  PlantLostCells(tissue.labels, grid, points);
  execution.Report(1.0);
  return tissue;
}
} // namespace

Box
PaddedBox(const std::vector<Point> & points)
{
  RefusePoints(points);
  const std::vector<double> spacings = LocalSpacings(points);
  const double              padding = *std::max_element(spacings.begin(), spacings.end());
  Box                       box{ points.front(), points.front() };
  for (const Point & point : points)
  {
    Extend(box, point);
  }
  for (int i = 0; i < 3; ++i)
  {
    box.lower[i] -= padding;
    box.upper[i] += padding;
  }
  return box;
}

std::vector<std::size_t>
FindOutliers(const std::vector<Point> & points)
{
  constexpr std::size_t neighbors = 4;
  constexpr double      farther = 10.0;
  std::vector<double>   distances;
  const auto            nearest = FindNearestPoints(points, neighbors);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    distances.push_back(nearest[i].empty() ? 0.0 : Distance(points[i], points[nearest[i].back()]));
  }
  std::vector<std::size_t> outliers;
  const double             most = distances.empty() ? 0.0 : farther * Median(distances);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (distances[i] > most)
    {
      outliers.push_back(i);
    }
  }
  return outliers;
}

TissueGrid
MakePointGrid(const std::vector<Point> & points, const Box & box, double voxelsPerCell)
{
  if (!(voxelsPerCell >= LeastVoxelsPerCell))
  {
    throw std::invalid_argument("voxelsPerCell is " + std::to_string(voxelsPerCell) + ", but must be at least " +
                                std::to_string(LeastVoxelsPerCell));
  }
  RefusePoints(points);
  const std::vector<double> spacings = LocalSpacings(points);
  const double              step = MeanSpacing(spacings) / std::cbrt(CubedSpacingOfCell * voxelsPerCell);
  const Point               extent = box.upper - box.lower;
  const double              voxels = extent[0] / step * (extent[1] / step) * (extent[2] / step);
  if (!(voxels <= MostVoxels))
  {
    const auto         farthest = std::max_element(spacings.begin() + 1, spacings.end()) - (spacings.begin() + 1);
    std::ostringstream message;
    message << "The box from " << ToText(box.lower) << " to " << ToText(box.upper) << " has " << voxels << " voxels at "
            << voxelsPerCell << " a cell, must have " << MostVoxels << " at most; point " << farthest << " at "
            << ToText(points[static_cast<std::size_t>(farthest)]) << " is the farthest from its nearest";
    throw std::invalid_argument(message.str());
  }
  return MakeTissueGrid(box, step);
}

PointTissue
EstimateTissue(const std::vector<Point> & points, const TissueGrid & grid, TissueLayering layering,
               const Execution & execution)
{
  RefusePoints(points);
  RefusePointsOutside(points, grid);
  if (layering != TissueLayering::Solid)
  {
    const TissueLayer layer(points);
    if (layering == TissueLayering::Layer || layer.IsEvident())
    {
      return EstimateLayer(layer, points, grid, execution);
    }
  }
  return EstimateSolid(points, grid, execution);
}
} // namespace tissue
