/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/IndicatorField.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
constexpr int    NumberOfNewtonSteps = 8;
constexpr double LeastIndicator = 0.01;

struct Spline
{
  int                   first;
  std::array<double, 4> weights;
  std::array<double, 4> derivatives;
};

Spline
SplineAt(double x)
{
  const double floor = std::floor(x);
  const double t = x - floor;
  const double s = 1.0 - t;
  Spline       spline;
  spline.first = static_cast<int>(floor) - 1;
  spline.weights = { { s * s * s / 6.0,
                       (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
                       (3.0 * s * s * s - 6.0 * s * s + 4.0) / 6.0,
                       t * t * t / 6.0 } };
  spline.derivatives = { { -s * s / 2.0, (3.0 * t - 4.0) * t / 2.0, (4.0 - 3.0 * s) * s / 2.0, t * t / 2.0 } };
  return spline;
}

/** Solves the symmetric positive definite system of one to three unknowns, slightly damped, in place. */
void
SolveDamped(std::array<std::array<double, 3>, 3> & a, std::array<double, 3> & b, int n)
{
  double trace = 0.0;
  for (int i = 0; i < n; ++i)
  {
    trace += a[i][i];
  }
  for (int i = 0; i < n; ++i)
  {
    a[i][i] += 1e-3 * trace;
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = i + 1; j < n; ++j)
    {
      const double factor = a[j][i] / a[i][i];
      for (int k = i; k < n; ++k)
      {
        a[j][k] -= factor * a[i][k];
      }
      b[j] -= factor * b[i];
    }
  }
  for (int i = n - 1; i >= 0; --i)
  {
    for (int k = i + 1; k < n; ++k)
    {
      b[i] -= a[i][k] * b[k];
    }
    b[i] /= a[i][i];
  }
}
} // namespace

IndicatorField::IndicatorField(const LabelVolume & volume)
  : m_Volume(volume)
{
  const auto & s = volume.steps;
  const double determinant = Dot(s[0], Cross(s[1], s[2]));
  for (int i = 0; i < 3; ++i)
  {
    m_Inverse[i] = (1.0 / determinant) * Cross(s[(i + 1) % 3], s[(i + 2) % 3]);
  }
}

double
IndicatorField::LengthInVoxels(const Point & vector) const
{
  return Norm({ { Dot(m_Inverse[0], vector), Dot(m_Inverse[1], vector), Dot(m_Inverse[2], vector) } });
}

IndicatorField::Sample
IndicatorField::Evaluate(const Point & point, const VertexQuadruple & cells, int count) const
{
  const Point          offset = point - m_Volume.origin;
  const Spline         x = SplineAt(Dot(m_Inverse[0], offset));
  const Spline         y = SplineAt(Dot(m_Inverse[1], offset));
  const Spline         z = SplineAt(Dot(m_Inverse[2], offset));
  Sample               sample;
  std::array<Point, 4> gradients{};
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      const double yz = y.weights[j] * z.weights[k];
      const double dyz = y.derivatives[j] * z.weights[k];
      const double ydz = y.weights[j] * z.derivatives[k];
      for (int i = 0; i < 4; ++i)
      {
        const VertexId vertex = m_Volume.At(x.first + i, y.first + j, z.first + k);
        for (int c = 0; c < count; ++c)
        {
          if (cells[c] == vertex)
          {
            sample.values[c] += x.weights[i] * yz;
            gradients[c][0] += x.derivatives[i] * yz;
            gradients[c][1] += x.weights[i] * dyz;
            gradients[c][2] += x.weights[i] * ydz;
          }
        }
      }
    }
  }
  for (int c = 0; c < count; ++c)
  {
    const Point & g = gradients[c];
    sample.gradients[c] = g[0] * m_Inverse[0] + g[1] * m_Inverse[1] + g[2] * m_Inverse[2];
  }
  return sample;
}

bool
IndicatorField::Project(Point & point, const VertexQuadruple & cells, int count, double reach) const
{
  const int equations = count - 1;
  Point     p = point;
  for (int step = 0; step < NumberOfNewtonSteps; ++step)
  {
    const Sample          sample = this->Evaluate(p, cells, count);
    std::array<Point, 3>  rows;
    std::array<double, 3> residual{};
    for (int c = 0; c < count; ++c)
    {
      if (sample.values[c] < LeastIndicator)
      {
        return false;
      }
    }
    for (int e = 0; e < equations; ++e)
    {
      rows[e] = sample.gradients[e + 1] - sample.gradients[0];
      residual[e] = sample.values[0] - sample.values[e + 1];
    }
    std::array<std::array<double, 3>, 3> matrix{};
    for (int e = 0; e < equations; ++e)
    {
      for (int f = 0; f < equations; ++f)
      {
        matrix[e][f] = Dot(rows[e], rows[f]);
      }
    }
    SolveDamped(matrix, residual, equations);
    Point move{ { 0.0, 0.0, 0.0 } };
    for (int e = 0; e < equations; ++e)
    {
      move = move + residual[e] * rows[e];
    }
    const double length = this->LengthInVoxels(move);
    if (!std::isfinite(length))
    {
      return false;
    }
    p = p + std::min(1.0, 1.0 / std::max(length, 1e-12)) * move;
    if (this->LengthInVoxels(p - point) > reach)
    {
      return false;
    }
    if (length < 1e-3)
    {
      break;
    }
  }
  point = p;
  return true;
}

Point
IndicatorField::LineDirection(const Point & point, const VertexTriple & cells) const
{
  const Sample sample = this->Evaluate(point, { { cells[0], cells[1], cells[2], -1 } }, 3);
  for (int c = 0; c < 3; ++c)
  {
    if (sample.values[c] < LeastIndicator)
    {
      return { { 0.0, 0.0, 0.0 } };
    }
  }
  return Cross(sample.gradients[1] - sample.gradients[0], sample.gradients[2] - sample.gradients[0]);
}
} // namespace tissue
