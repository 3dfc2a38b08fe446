/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Statistics/SurfaceFit.h"

#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
/** The height is 1, x, y, xx, xy, yy times these. */
using Coefficients = Eigen::Matrix<double, 6, 1>;

/** Where heights are measured: over a plane through the origin. */
struct Frame
{
  Point origin;
  Point u;
  Point v;
  Point normal;
};

Frame
MakeFrame(const Point & origin, const Point & normal)
{
  const auto * least =
    std::min_element(normal.begin(), normal.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  Point axis{ { 0.0, 0.0, 0.0 } };
  axis[static_cast<std::size_t>(least - normal.begin())] = 1.0;
  const Point u = Normalized(Cross(axis, normal));
  return { origin, u, Cross(normal, u), normal };
}

/** The frame with another normal and origin that is turned least. */
Frame
Tilt(const Frame & frame, const Point & normal, const Point & origin)
{
  const Point u = Normalized(frame.u - Dot(frame.u, normal) * normal);
  return { origin, u, Cross(normal, u), normal };
}

/** What a circle is higher than the parabola of its curvature. Of steep circles it is that where they are not yet. */
double
CircleOverParabola(double curvature, double distance)
{
  constexpr double steepest = 0.9;
  const double     sine = std::clamp(curvature * distance, -steepest, steepest);
  return distance * sine * (1.0 / (1.0 + std::sqrt(1.0 - sine * sine)) - 0.5);
}

double
Quadratic(const Coefficients & c, double x, double y)
{
  return c[3] * x * x + c[4] * x * y + c[5] * y * y;
}

struct HeightFit
{
  Coefficients coefficients = Coefficients::Zero();
  /** Root mean square. */
  double residual = 0.0;
  bool   isUnique = false;
};

/** Fits a quadratic height, all in units of a length. \param known the quadratic part that was found before, whose
 * arcs' deviation from parabolas is taken off the heights. */
HeightFit
FitHeights(const std::vector<SurfaceSample> & samples, const Frame & frame, double length, const Coefficients & known)
{
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Coefficients                right = Coefficients::Zero();
  double                      squares = 0.0;
  double                      area = 0.0;
  for (const SurfaceSample & sample : samples)
  {
    const Point  p = (1.0 / length) * (sample.position - frame.origin);
    const double x = Dot(p, frame.u);
    const double y = Dot(p, frame.v);
    const double distance = std::hypot(x, y);
    const double curvature = distance > 0.0 ? 2.0 * Quadratic(known, x, y) / (distance * distance) : 0.0;
    const double z = Dot(p, frame.normal) - CircleOverParabola(curvature, distance);
    Coefficients row;
    row << 1.0, x, y, x * x, x * y, y * y;
    matrix += sample.area * row * row.transpose();
    right += sample.area * z * row;
    squares += sample.area * z * z;
    area += sample.area;
  }
  constexpr double                                        leastPivot = 1e-9;
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 6, 6>> solver;
  solver.setThreshold(leastPivot);
  solver.compute(matrix);
  HeightFit fit;
  fit.isUnique = solver.isInvertible();
  fit.coefficients = solver.solve(right);
  fit.residual = std::sqrt(std::max(0.0, squares - fit.coefficients.dot(right)) / area);
  return fit;
}

/** Along the outward normal a ball falls off: its curvatures are positive. */
Curvatures
CurvaturesOf(const Coefficients & c, double length)
{
  const double mean = -(c[3] + c[5]);
  const double half = std::hypot(c[3] - c[5], c[4]);
  return { (mean + half) / length, (mean - half) / length };
}

struct Spread
{
  double area = 0.0;
  /** Root mean square distance to the mean. */
  double distance = 0.0;
  double planeDistance = 0.0;
};

Spread
MeasureSpread(const std::vector<SurfaceSample> & samples)
{
  Spread spread;
  Point  mean{ { 0.0, 0.0, 0.0 } };
  for (const SurfaceSample & sample : samples)
  {
    mean = mean + sample.area * sample.position;
    spread.area += sample.area;
  }
  if (!(spread.area > 0.0))
  {
    return spread;
  }
  mean = (1.0 / spread.area) * mean;
  Metric covariance{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
  for (const SurfaceSample & sample : samples)
  {
    AddOuterProduct(sample.area / spread.area, sample.position - mean, covariance);
  }
  const auto values = DecomposeSymmetric(covariance).values;
  spread.distance = std::sqrt(covariance[0] + covariance[3] + covariance[5]);
  spread.planeDistance = std::sqrt(std::max(0.0, *std::min_element(values.begin(), values.end())));
  return spread;
}
} // namespace

SurfaceRelief
MeasureRelief(const std::vector<SurfaceSample> & samples, const Point & center, const Point & normal)
{
  const Spread  spread = MeasureSpread(samples);
  SurfaceRelief relief;
  if (spread.distance > 0.0)
  {
    relief.planeDistance = spread.planeDistance;
    const HeightFit fit = FitHeights(samples, MakeFrame(center, normal), spread.distance, Coefficients::Zero());
    relief.roughness = fit.isUnique ? spread.distance * fit.residual : UnknownStatistic;
  }
  return relief;
}

Curvatures
FitSurface(const std::vector<SurfaceSample> & samples, const Point & center, const Point & normal)
{
  // The arcs' curvatures and the normal are found by turns, from those of parabolas and the given normal on.
  constexpr int    mostTurns = 20;
  constexpr double leastChange = 1e-4;
  const double     length = MeasureSpread(samples).distance;
  if (!(length > 0.0))
  {
    return {};
  }
  Frame     frame = MakeFrame(center, normal);
  HeightFit fit = FitHeights(samples, frame, length, Coefficients::Zero());
  if (!fit.isUnique)
  {
    return {};
  }
  for (int turn = 0; turn < mostTurns; ++turn)
  {
    const Coefficients c = fit.coefficients;
    const Point        onSurface = frame.origin + length * c[0] * frame.normal;
    const Point        tilted = Normalized(frame.normal - c[1] * frame.u - c[2] * frame.v);
    const Frame        next = Tilt(frame, tilted, center + Dot(onSurface - center, tilted) * tilted);
    const HeightFit    better = FitHeights(samples, next, length, c);
    if (!better.isUnique)
    {
      break;
    }
    frame = next;
    fit = better;
    if ((better.coefficients - c).norm() < leastChange)
    {
      break;
    }
  }
  return CurvaturesOf(fit.coefficients, length);
}

Curvatures
FitNormals(const std::vector<SurfacePart> & parts, const Point & center, const Point & normal)
{
  // The normal along u and v is a linear function of the place: a, b, and the symmetric gradient s, t, t, r.
  using Vector = Eigen::Matrix<double, 5, 1>;
  constexpr double            leastPivot = 1e-9;
  Eigen::Matrix<double, 5, 5> matrix = Eigen::Matrix<double, 5, 5>::Zero();
  Vector                      right = Vector::Zero();
  const Frame                 frame = MakeFrame(center, normal);
  double                      length = 0.0;
  for (const SurfacePart & part : parts)
  {
    length = std::max(length, Distance(part.center, center));
  }
  for (const SurfacePart & part : parts)
  {
    const Point  way = (length > 0.0 ? 1.0 / length : 0.0) * (part.center - center);
    const double x = Dot(way, frame.u);
    const double y = Dot(way, frame.v);
    const Point  direction = Normalized(part.normal);
    Vector       alongU;
    Vector       alongV;
    alongU << 1.0, 0.0, x, y, 0.0;
    alongV << 0.0, 1.0, 0.0, x, y;
    matrix += part.area * (alongU * alongU.transpose() + alongV * alongV.transpose());
    right += part.area * (Dot(direction, frame.u) * alongU + Dot(direction, frame.v) * alongV);
  }
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 5, 5>> solver;
  solver.setThreshold(leastPivot);
  solver.compute(matrix);
  if (parts.size() < 3 || !solver.isInvertible())
  {
    return {};
  }
  const Vector gradient = solver.solve(right) / length;
  const double mean = 0.5 * (gradient[2] + gradient[4]);
  const double half = std::hypot(0.5 * (gradient[2] - gradient[4]), gradient[3]);
  return { mean + half, mean - half };
}
} // namespace tissue
