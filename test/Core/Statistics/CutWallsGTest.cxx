/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/CutWalls.h"

#include "LatticeTissue.h"
#include "Statistics/SolidMoments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{
using namespace tissue;
using namespace tissue_test;

constexpr int    Side = 84;
constexpr double Middle = 0.5 * (Side - 1);
constexpr double Radius = 40.0;

bool
IsInBall(const Point & p, double radius)
{
  return Distance(p, { { Middle, Middle, Middle } }) <= radius;
}

/** With few triangles, but as many cells as any. */
template <typename TIsInside>
LatticeTissue
Make(const LabelVolume & volume, const TIsInside & isInside)
{
  ReconstructionParameters parameters;
  parameters.refinement = 0;
  return MakeLatticeTissue(volume, 6, isInside, parameters);
}

OuterSurface
FindSurface(const LatticeTissue & tissue)
{
  std::vector<double> areas;
  for (const SolidMoments & solid : MeasureSolids(tissue.mesh, tissue.junctions.cells.size()))
  {
    areas.push_back(solid.area);
  }
  return FindOuterSurface(tissue.mesh, tissue.junctions.cells, areas, tissue.junctions.grid);
}

/** The share of the area of walls that `isMeant` picks where the tissue is cut. */
template <typename TIsMeant>
double
ShareOfCut(const OuterSurface & surface, const TIsMeant & isMeant)
{
  double cut = 0.0;
  double all = 0.0;
  for (const OuterWall & wall : surface.walls)
  {
    all += isMeant(wall.center) ? wall.area : 0.0;
    cut += isMeant(wall.center) && wall.isCut ? wall.area : 0.0;
  }
  EXPECT_GT(all, 0.0);
  return cut / all;
}

/** The area that is cut in all. */
double
CutArea(const OuterSurface & surface)
{
  return std::accumulate(surface.cutAreas.begin(), surface.cutAreas.end(), 0.0);
}
} // namespace

TEST(CutWalls, ABallHasNone)
{
  const auto tissue =
    Make(EmptyVolume({ { Side, Side, Side } }), [](const Point & p, const Point &) { return IsInBall(p, 28.0); });
  EXPECT_EQ(CutArea(FindSurface(tissue)), 0.0);
}

TEST(CutWalls, APlaneWithinTheImageIsOneOfTriangles)
{
  const Point  normal = Normalized(Point{ { 0.3, -0.2, -1.0 } });
  const auto   tissue = Make(EmptyVolume({ { Side, Side, Side } }), [&](const Point & p, const Point &) {
    return IsInBall(p, Radius) && Dot(p - Point{ { Middle, Middle, Middle } }, normal) <= 4.0;
  });
  const double disk = std::acos(-1.0) * (Radius * Radius - 16.0);
  EXPECT_NEAR(CutArea(FindSurface(tissue)), disk, 0.05 * disk);
}

TEST(CutWalls, WhereWholeCellsAreMissingTheyAreAll)
{
  const auto         tissue = Make(EmptyVolume({ { Side, Side, Side } }), [](const Point & p, const Point & seed) {
    return IsInBall(p, Radius) && seed[2] >= Middle - 8.0;
  });
  const OuterSurface surface = FindSurface(tissue);
  EXPECT_EQ(ShareOfCut(surface, [](const Point & p) { return IsInBall(p, Radius - 6.0); }), 1.0);
  EXPECT_LT(ShareOfCut(surface, [](const Point & p) { return p[2] > Middle + 6.0; }), 0.01);
}

TEST(CutWalls, TheSidesOfABlockAreNone)
{
  const auto tissue = Make(EmptyVolume({ { 60, 60, 60 } }), [](const Point & p, const Point &) {
    return *std::min_element(p.begin(), p.end()) >= 5.0 && *std::max_element(p.begin(), p.end()) <= 55.0;
  });
  EXPECT_EQ(CutArea(FindSurface(tissue)), 0.0);
}

TEST(CutWalls, AFlatSheetOfOneLayerHasNone)
{
  const auto tissue = Make(EmptyVolume({ { 120, 120, 12 } }), [](const Point & p, const Point &) {
    return std::hypot(p[0] - 60.0, p[1] - 60.0) <= 57.0 && p[2] >= 3.0 && p[2] < 9.0;
  });
  EXPECT_EQ(CutArea(FindSurface(tissue)), 0.0);
}
