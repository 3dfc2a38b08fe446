/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/PointTissue.h"

#include "TissueTessellationCore/DelaunayTetrahedralization.h"
#include "TissueTessellationCore/LocalSpacing.h"
#include "TissueTessellationCore/SurfaceCleanUp.h"
#include "TissueTessellationCore/Vector.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tissue
{
namespace
{
constexpr double LeastVoxelsPerCell = 50.0;
/** Of a surface triangle's edges, in units of the local spacing. */
constexpr double MaximumEdgeLength = 1.6;
constexpr double DepthFraction = 0.4;
/** The cube of the mean distance of the eight nearest is so many times the volume of a cell, in plant tissues. */
constexpr double CubedSpacingOfCell = 1.17;
constexpr double MaskShare = 0.15;
constexpr double FitShare = 0.95;

std::string
ToText(const Point & p)
{
  return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " + std::to_string(p[2]) + ")";
}

/** The points as the positions of vertices, after the exterior's. */
std::vector<Point>
MakeCenters(const std::vector<Point> & points)
{
  std::vector<Point> centers{ { { 0.0, 0.0, 0.0 } } };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!std::all_of(points[i].begin(), points[i].end(), [](double value) { return std::isfinite(value); }))
    {
      throw std::invalid_argument("point " + std::to_string(i) + " is at " + ToText(points[i]) +
                                  ", but coordinates must be finite");
    }
    centers.push_back(points[i]);
  }
  return centers;
}

void
RefusePointsOutside(const std::vector<Point> & points, const TissueGrid & grid)
{
  Box box{ grid.lower, grid.lower };
  for (int i = 0; i < 3; ++i)
  {
    box.upper[i] += grid.size[i] * grid.steps[i];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!Overlap({ points[i], points[i] }, box))
    {
      throw std::invalid_argument("point " + std::to_string(i) + " at " + ToText(points[i]) +
                                  " is outside of the box from " + ToText(box.lower) + " to " + ToText(box.upper));
    }
  }
}

AdjacencyComplex
MakeDelaunay(const std::vector<Point> & centers)
{
  return AdjacencyComplex(static_cast<VertexId>(centers.size()), DelaunayTetrahedralization(centers));
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

TissueMask
EstimateMask(const std::vector<Point> & centers, const TissueGrid & grid, const ParallelFor & parallelFor)
{
  AdjacencyComplex         complex = MakeDelaunay(centers);
  SurfaceCleanUpParameters cleanUp;
  cleanUp.maximumEdgeLength = MaximumEdgeLength;
  cleanUp.localLengths = LocalSpacings(complex, centers);
  CleanSurface(complex, centers, nullptr, cleanUp);
  const auto depths = EstimateSurfaceDepths(complex, centers, cleanUp.localLengths, DepthFraction);
  return EstimateTissueMask(complex, centers, depths, grid, parallelFor);
}

/** A grid point for each point that has none: its own, unless another cell has no other. */
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
} // namespace

Box
PaddedBox(const std::vector<Point> & points)
{
  const std::vector<Point>  centers = MakeCenters(points);
  const std::vector<double> spacings = LocalSpacings(MakeDelaunay(centers), centers);
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

TissueGrid
MakePointGrid(const std::vector<Point> & points, const Box & box, double voxelsPerCell)
{
  if (!(voxelsPerCell >= LeastVoxelsPerCell))
  {
    throw std::invalid_argument("voxelsPerCell is " + std::to_string(voxelsPerCell) + ", but must be at least " +
                                std::to_string(LeastVoxelsPerCell));
  }
  const std::vector<Point> centers = MakeCenters(points);
  const double             spacing = MeanSpacing(LocalSpacings(MakeDelaunay(centers), centers));
  return MakeTissueGrid(box, spacing / std::cbrt(CubedSpacingOfCell * voxelsPerCell));
}

std::vector<std::int32_t>
EstimateTissue(const std::vector<Point> & points, const TissueGrid & grid, const CentroidFitOptions & options,
               const ParallelFor & parallelFor, const ProgressFunction & progress)
{
  const std::vector<Point> centers = MakeCenters(points);
  RefusePointsOutside(points, grid);
  const TissueSamples samples = SampleMask(EstimateMask(centers, grid, parallelFor));
  Report(progress, MaskShare);
  const auto                seeds = FitCentroids(samples, points, options, parallelFor, [&](double fraction) {
    return !progress || progress(MaskShare + (FitShare - MaskShare) * fraction);
  });
  const auto                cells = AssignSamples(AnisotropicTessellation(seeds), samples, parallelFor);
  std::vector<std::int32_t> labels(grid.NumberOfPoints(), 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    labels[grid.OffsetAt(samples.points[i])] = cells[i] + 1;
  }
  PlantLostCells(labels, grid, points);
  Report(progress, 1.0);
  return labels;
}
} // namespace tissue
