/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/SurfaceFit.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using namespace tissue;

/** Samples of a height over the plane z = 0 in a square of twice this half side about a place. */
std::vector<SurfaceSample>
SampleHeights(const std::function<double(double, double)> & height, double half, double x0 = 0.0, double y0 = 0.0)
{
  std::vector<SurfaceSample> samples;
  constexpr int              steps = 8;
  for (int i = -steps; i <= steps; ++i)
  {
    for (int j = -steps; j <= steps; ++j)
    {
      const double x = x0 + half * i / steps;
      const double y = y0 + half * j / steps;
      samples.push_back({ { { x, y, height(x, y) } }, 1.0 });
    }
  }
  return samples;
}

const Point Up{ { 0, 0, 1 } };
} // namespace

TEST(SurfaceFit, OfABallHasItsCurvatureWhateverTheSizeOfThePatch)
{
  const double radius = 10.0;
  const auto   ball = [radius](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); };
  for (const double half : { 0.5, 3.0, 5.0 })
  {
    const Curvatures fit = FitSurface(SampleHeights(ball, half), { { 0, 0, radius } }, Up);
    EXPECT_NEAR(fit.maximum, 0.1, 1e-4) << half;
    EXPECT_NEAR(fit.minimum, 0.1, 1e-4) << half;
    EXPECT_NEAR(fit.Mean(), 0.1, 1e-4);
    EXPECT_NEAR(fit.Gaussian(), 0.01, 2e-5);
  }
}

TEST(SurfaceFit, FindsTheNormalAndTheFootOfTheCentre)
{
  // A patch of the ball whose normal is 30 degrees off the given one, with the centre of the patch below the surface.
  const double     radius = 10.0;
  const auto       ball = [radius](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); };
  const Curvatures fit = FitSurface(SampleHeights(ball, 2.0, 5.0), { { 4.8, 0.0, 8.3 } }, Up);
  EXPECT_NEAR(fit.maximum, 0.1, 1e-3);
  EXPECT_NEAR(fit.minimum, 0.1, 1e-3);
}

TEST(SurfaceFit, OfACylinderIsFlatAlongIt)
{
  const auto       cylinder = [](double x, double) { return std::sqrt(16.0 - x * x); };
  const Curvatures fit = FitSurface(SampleHeights(cylinder, 2.0), { { 0, 0, 4 } }, Up);
  EXPECT_NEAR(fit.maximum, 0.25, 0.25 * 0.02);
  EXPECT_NEAR(fit.minimum, 0.0, 0.25 * 0.02);
}

TEST(SurfaceFit, SeesTheCurvaturesAlongTheNormal)
{
  const auto       saddle = [](double x, double y) { return 0.5 * (0.1 * x * x - 0.3 * y * y); };
  const auto       samples = SampleHeights(saddle, 0.2);
  const Curvatures above = FitSurface(samples, { { 0, 0, 0 } }, Up);
  EXPECT_NEAR(above.maximum, 0.3, 1e-3);
  EXPECT_NEAR(above.minimum, -0.1, 1e-3);
  EXPECT_NEAR(above.Mean(), 0.1, 1e-3);
  EXPECT_NEAR(above.Gaussian(), -0.03, 1e-3);
  const Curvatures below = FitSurface(samples, { { 0, 0, 0 } }, -1.0 * Up);
  EXPECT_NEAR(below.maximum, 0.1, 1e-3);
  EXPECT_NEAR(below.minimum, -0.3, 1e-3);
}

TEST(SurfaceRelief, RoughnessIsTheDistanceToAQuadraticSurface)
{
  // A checkerboard of heights is rough by its height; a parabola is smooth, though off the plane.
  int        count = 0;
  const auto board = [&count](double, double) { return ++count % 2 == 0 ? 0.25 : -0.25; };
  EXPECT_NEAR(MeasureRelief(SampleHeights(board, 1.0), { { 0, 0, 0 } }, Up).roughness, 0.25, 0.01);
  const auto          parabola = [](double x, double) { return x * x; };
  const SurfaceRelief fit = MeasureRelief(SampleHeights(parabola, 1.0), { { 0, 0, 0 } }, Up);
  EXPECT_NEAR(fit.roughness, 0.0, 1e-6);
  EXPECT_GT(fit.planeDistance, 0.2);
}

TEST(SurfaceRelief, PlaneDistanceIsZeroInAnyPlane)
{
  const auto          plane = [](double x, double y) { return 0.5 * x - 0.3 * y + 7.0; };
  const SurfaceRelief fit = MeasureRelief(SampleHeights(plane, 1.0), { { 0, 0, 7 } }, Up);
  EXPECT_NEAR(fit.planeDistance, 0.0, 1e-6);
  EXPECT_NEAR(FitSurface(SampleHeights(plane, 1.0), { { 0, 0, 7 } }, Up).Mean(), 0.0, 1e-6);
}

TEST(SurfaceFit, KnowsNoCurvaturesOfTooFewSamples)
{
  EXPECT_TRUE(std::isnan(MeasureRelief({}, { { 0, 0, 0 } }, Up).planeDistance));
  EXPECT_TRUE(std::isnan(FitSurface({}, { { 0, 0, 0 } }, Up).Mean()));
  // Five places, each several times, as the triangles of a square with its middle have them.
  std::vector<SurfaceSample> samples;
  for (int i = 0; i < 3; ++i)
  {
    for (const Point & p : { Point{ { 0, 0, 1 } },
                             Point{ { 1, 1, 0 } },
                             Point{ { -1, 1, 0 } },
                             Point{ { 1, -1, 0 } },
                             Point{ { -1, -1, 0 } } })
    {
      samples.push_back({ p, 1.0 });
    }
  }
  const SurfaceRelief few = MeasureRelief(samples, { { 0, 0, 0 } }, Up);
  EXPECT_TRUE(std::isnan(FitSurface(samples, { { 0, 0, 0 } }, Up).Mean()));
  EXPECT_TRUE(std::isnan(few.roughness));
  EXPECT_NEAR(few.planeDistance, 0.4, 1e-9);
}

TEST(FitNormals, OfPartsOfABallHasItsCurvatures)
{
  std::vector<SurfacePart> parts;
  for (const double angle : { 0.0, 0.7, 1.9, 3.0, 4.2, 5.5 })
  {
    const Point direction = Normalized(Point{ { 0.3 * std::cos(angle), 0.3 * std::sin(angle), 1.0 } });
    parts.push_back({ 20.0 * direction, 2.0 * direction, 3.0 });
  }
  parts.push_back({ 20.0 * Up, 5.0 * Up, 5.0 });
  const Curvatures ball = FitNormals(parts, 20.0 * Up, Up);
  EXPECT_NEAR(ball.maximum, 0.05, 1e-9);
  EXPECT_NEAR(ball.minimum, 0.05, 1e-9);
  parts.resize(2);
  EXPECT_TRUE(std::isnan(FitNormals(parts, 20.0 * Up, Up).Mean()));
  EXPECT_TRUE(std::isnan(FitNormals({}, 20.0 * Up, Up).Mean()));
}

TEST(FitNormals, OfASaddleHasBothSigns)
{
  std::vector<SurfacePart> parts;
  for (const auto & [x, y] :
       { std::array<double, 2>{ { 0.1, 0.0 } }, { { -0.1, 0.0 } }, { { 0.0, 0.1 } }, { { 0.1, 0.1 } } })
  {
    // The normal of z = (0.1 x^2 - 0.3 y^2) / 2, turned by 30 degrees about z.
    const double c = std::cos(0.5);
    const double s = std::sin(0.5);
    const Point  normal = Normalized(Point{ { -0.1 * x, 0.3 * y, 1.0 } });
    parts.push_back({ { { c * x - s * y, s * x + c * y, 0.0 } },
                      { { c * normal[0] - s * normal[1], s * normal[0] + c * normal[1], normal[2] } },
                      1.0 });
  }
  const Curvatures saddle = FitNormals(parts, { { 0, 0, 0 } }, Up);
  EXPECT_NEAR(saddle.maximum, 0.3, 1e-3);
  EXPECT_NEAR(saddle.minimum, -0.1, 1e-3);
}
