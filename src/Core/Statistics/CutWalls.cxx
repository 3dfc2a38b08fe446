/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/CutWalls.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace tissue
{
namespace
{
/** The least shares of the surface that the cores of cuts make up. */
constexpr double LeastShareOfPlane = 0.05;
constexpr double LeastShareOfRough = 0.1;

/** Walls that hang together. */
using Region = std::vector<std::size_t>;

double
SumAreas(const OuterSurface & surface, const Region & region)
{
  double area = 0.0;
  for (const std::size_t w : region)
  {
    area += surface.walls[w].area;
  }
  return area;
}

/** Whether the regions make up no more than this share of the surface. */
bool
AreAtMost(const OuterSurface & surface, const std::vector<Region> & regions, double share)
{
  double area = 0.0;
  for (const Region & region : regions)
  {
    area += SumAreas(surface, region);
  }
  double all = 0.0;
  for (const OuterWall & wall : surface.walls)
  {
    all += wall.area;
  }
  return area <= share * all;
}

/** The mean diameter of the cells of a wall and those about it. */
double
DiameterAround(const OuterSurface & surface, std::size_t wall)
{
  double     sum = surface.walls[wall].diameter;
  const auto neighbors = surface.neighbors[wall];
  for (const std::size_t neighbor : neighbors)
  {
    sum += surface.walls[neighbor].diameter;
  }
  return sum / static_cast<double>(1 + neighbors.size());
}

/** Of each wall the median over it and those about it of measure(relief, diameter), which is 0 where it is not known.
 */
template <typename TMeasure>
std::vector<double>
SmoothReliefs(const OuterSurface & surface, const TMeasure & measure)
{
  const std::size_t   count = surface.walls.size();
  std::vector<double> values(count, 0.0);
  for (std::size_t w = 0; w < count; ++w)
  {
    const SurfaceRelief relief = ReliefAround(surface, w);
    values[w] = std::isnan(relief.roughness) ? 0.0 : measure(relief, DiameterAround(surface, w));
  }
  std::vector<double> medians(count);
  for (std::size_t w = 0; w < count; ++w)
  {
    std::vector<double> around{ values[w] };
    for (const std::size_t neighbor : surface.neighbors[w])
    {
      around.push_back(values[neighbor]);
    }
    medians[w] = Median(around);
  }
  return medians;
}

/** The regions of the walls for which the test holds. */
template <typename TTest>
std::vector<Region>
FindRegions(const OuterSurface & surface, const TTest & test)
{
  DisjointSets sets(surface.walls.size());
  for (std::size_t w = 0; w < surface.walls.size(); ++w)
  {
    for (const std::size_t neighbor : surface.neighbors[w])
    {
      if (test(w) && test(neighbor))
      {
        sets.Unite(static_cast<std::int64_t>(w), static_cast<std::int64_t>(neighbor));
      }
    }
  }
  std::map<std::int64_t, Region> regionOf;
  for (std::size_t w = 0; w < surface.walls.size(); ++w)
  {
    if (test(w))
    {
      regionOf[sets.Find(static_cast<std::int64_t>(w))].push_back(w);
    }
  }
  std::vector<Region> regions;
  for (const auto & entry : regionOf)
  {
    regions.push_back(entry.second);
  }
  return regions;
}

/** The cores of such regions, without the walls that have others for neighbours, that make up more than a share
 * of the surface: the edge of a sheet and a crease between two organs are narrow, and have none. */
template <typename TTest>
std::vector<Region>
FindCores(const OuterSurface & surface, double leastShare, const TTest & test)
{
  const auto isCore = [&](std::size_t w) {
    const auto neighbors = surface.neighbors[w];
    return test(w) && std::all_of(neighbors.begin(), neighbors.end(), test);
  };
  std::vector<Region> cores = FindRegions(surface, isCore);
  const auto          isSmall = [&](const Region & core) { return AreAtMost(surface, { core }, leastShare); };
  cores.erase(std::remove_if(cores.begin(), cores.end(), isSmall), cores.end());
  return cores;
}

/** How far walls are off a plane that they lie in. A plane that is slanted to the voxels is as rough as a fit to these
 * leaves it. */
double
FlatnessOf(double diameter, double voxelLength)
{
  constexpr double ofDiameter = 0.01;
  constexpr double ofVoxel = 0.4;
  return std::max(ofDiameter * diameter, ofVoxel * voxelLength);
}

/** The plane of a region, if it lies in one; else its normal is 0. */
CutPlane
FitPlane(const OuterSurface & surface, const Region & region, double voxelLength)
{
  constexpr double           toleranceOverFlatness = 5.0;
  const double               area = SumAreas(surface, region);
  std::vector<SurfaceSample> samples;
  CutPlane                   plane;
  Point                      center{ { 0.0, 0.0, 0.0 } };
  double                     diameter = 0.0;
  for (const std::size_t w : region)
  {
    const OuterWall & wall = surface.walls[w];
    const auto        ofWall = surface.samples[w];
    samples.insert(samples.end(), ofWall.begin(), ofWall.end());
    plane.normal = plane.normal + wall.normal;
    center = center + wall.area / area * wall.center;
    diameter += wall.diameter / static_cast<double>(region.size());
  }
  plane.normal = Normalized(plane.normal);
  plane.offset = Dot(center, plane.normal);
  plane.tolerance = toleranceOverFlatness * FlatnessOf(diameter, voxelLength);
  const double distance = MeasureRelief(samples, center, plane.normal).planeDistance;
  return distance <= FlatnessOf(diameter, voxelLength) ? plane : CutPlane();
}
} // namespace

std::vector<CutPlane>
FindCutPlanes(const OuterSurface & surface, double voxelLength)
{
  constexpr std::size_t     fewestWalls = 8;
  constexpr double          parallelCosine = 0.97;
  const std::vector<double> reliefs =
    SmoothReliefs(surface, [voxelLength](const SurfaceRelief & relief, double diameter) {
      return relief.planeDistance / FlatnessOf(diameter, voxelLength);
    });
  std::vector<CutPlane> planes;
  for (const Region & region :
       FindCores(surface, LeastShareOfPlane, [&reliefs](std::size_t w) { return reliefs[w] <= 1.0; }))
  {
    const CutPlane plane = FitPlane(surface, region, voxelLength);
    if (region.size() < fewestWalls || !(Norm(plane.normal) > 0.0))
    {
      continue;
    }
    if (!planes.empty() && std::abs(Dot(planes.front().normal, plane.normal)) < parallelCosine)
    {
      return {};
    }
    planes.push_back(plane);
  }
  return planes;
}

void
MarkCutWalls(OuterSurface & surface)
{
  constexpr double          roughest = 0.1;
  constexpr double          most = 0.8;
  const std::vector<double> reliefs =
    SmoothReliefs(surface, [](const SurfaceRelief & relief, double diameter) { return relief.roughness / diameter; });
  const std::vector<Region> cuts =
    FindCores(surface, LeastShareOfRough, [&reliefs](std::size_t w) { return reliefs[w] > roughest; });
  if (!AreAtMost(surface, cuts, most))
  {
    return;
  }
  const auto markAll = [&surface](const Region & region) {
    for (const std::size_t w : region)
    {
      surface.walls[w].isCut = true;
    }
  };
  std::for_each(cuts.begin(), cuts.end(), markAll);
  // What is small and within a cut is one, too.
  for (const Region & rest : FindRegions(surface, [&surface](std::size_t w) { return !surface.walls[w].isCut; }))
  {
    if (!cuts.empty() && AreAtMost(surface, { rest }, LeastShareOfRough))
    {
      markAll(rest);
    }
  }
}
} // namespace tissue
