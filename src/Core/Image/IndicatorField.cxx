/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Image/IndicatorField.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <Eigen/Dense>

#include <algorithm>

namespace tissue
{
namespace
{
/** The most Gauss-Newton steps. Each is a voxel long at most and callers let a point move by three, so that most of the
 * steps are left to converge. */
constexpr int NumberOfNewtonSteps = 8;
/** The least indicator, of 0 .. 1, by which a cell is near a point. With less, its voxels are at the rim of the
 * spline's support, where the gradient says little about the place of the cell's boundary. */
constexpr double LeastIndicator = 0.01;
/** In shares of the trace of the equations' matrix. */
constexpr double Damping = 1e-3;

/** The four voxels along an axis that the cubic B-spline weighs at a coordinate, from the index `first` on. */
struct Spline
{
  int                   first;
  std::array<double, 4> weights;
  std::array<double, 4> derivatives;
};

/** The four cubic pieces of the uniform B-spline at x = floor(x) + t, and their derivatives; s = 1 - t mirrors them.
 * The weights add up to 1. */
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

/** Finds the least move that takes away the residuals, to first order and slightly damped, which keeps it short where
 * the gradients are nearly dependent. Each row is the gradient of an equation, or zero where there are fewer than
 * three, with a residual of zero. */
Point
SolveDamped(const Eigen::Matrix3d & rows, const Eigen::Vector3d & residual)
{
  Eigen::Matrix3d matrix = rows * rows.transpose();
  // This makes zero rows equations of their own, which change nothing.
  matrix.diagonal().array() += Damping * matrix.trace();
  // The damping bounds the condition number: of so small a matrix the inverse is exact enough, and fast.
  const Eigen::Vector3d move = rows.transpose() * (matrix.inverse() * residual);
  return { { move[0], move[1], move[2] } };
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

bool
IndicatorField::IsWithin(int x, int y, int z) const
{
  return x >= 0 && y >= 0 && z >= 0 && x + 4 <= m_Volume.size[0] && y + 4 <= m_Volume.size[1] &&
         z + 4 <= m_Volume.size[2];
}

IndicatorField::Row
IndicatorField::RowWithin(int x, int y, int z) const
{
  const std::size_t offset = (static_cast<std::size_t>(z) * m_Volume.size[1] + y) * m_Volume.size[0] + x;
  return m_Volume.vertices.Visit([offset](const auto * first) -> Row {
    return { { first[offset], first[offset + 1], first[offset + 2], first[offset + 3] } };
  });
}

IndicatorField::Row
IndicatorField::RowAt(int x, int y, int z) const
{
  return { { m_Volume.At(x, y, z), m_Volume.At(x + 1, y, z), m_Volume.At(x + 2, y, z), m_Volume.At(x + 3, y, z) } };
}

IndicatorField::Sample
IndicatorField::Evaluate(const Point & point, const VertexQuadruple & cells, int count) const
{
  // An indicator is the sum over its cell's voxels, of the 4 x 4 x 4 about the point, of the product of the three
  // splines. Rows of voxels are summed along the first axis, and their sums weighed by the two other splines. Gradients
  // are summed along the axes of the image; the rows of m_Inverse then turn them into physical ones.
  const Point          offset = point - m_Volume.origin;
  const Spline         x = SplineAt(Dot(m_Inverse[0], offset));
  const Spline         y = SplineAt(Dot(m_Inverse[1], offset));
  const Spline         z = SplineAt(Dot(m_Inverse[2], offset));
  const bool           isWithin = this->IsWithin(x.first, y.first, z.first);
  Sample               sample;
  std::array<Point, 4> gradients{};
  for (int k = 0; k < 4; ++k)
  {
    for (int j = 0; j < 4; ++j)
    {
      const Row row =
        isWithin ? this->RowWithin(x.first, y.first + j, z.first + k) : this->RowAt(x.first, y.first + j, z.first + k);
      const double yz = y.weights[j] * z.weights[k];
      const double dyz = y.derivatives[j] * z.weights[k];
      const double ydz = y.weights[j] * z.derivatives[k];
      for (int c = 0; c < count; ++c)
      {
        double weight = 0.0;
        double derivative = 0.0;
        for (int i = 0; i < 4; ++i)
        {
          weight += row[i] == cells[c] ? x.weights[i] : 0.0;
          derivative += row[i] == cells[c] ? x.derivatives[i] : 0.0;
        }
        sample.values[c] += weight * yz;
        gradients[c][0] += derivative * yz;
        gradients[c][1] += weight * dyz;
        gradients[c][2] += weight * ydz;
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
  // Gauss-Newton for f_c(p) = f_0(p), c = 1 .. count - 1. With J the rows grad f_c - grad f_0 and r = f_0 - f_c, the
  // shortest of all moves m with J m = r is J' (J J')^-1 r: across a wall or a line, not along it. Steps are cut to one
  // voxel, and end when one is below a thousandth of a voxel.
  const int equations = count - 1;
  Point     p = point;
  for (int step = 0; step < NumberOfNewtonSteps; ++step)
  {
    const Sample    sample = this->Evaluate(p, cells, count);
    Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
    Eigen::Vector3d residual = Eigen::Vector3d::Zero();
    for (int c = 0; c < count; ++c)
    {
      if (sample.values[c] < LeastIndicator)
      {
        return false;
      }
    }
    for (int e = 0; e < equations; ++e)
    {
      const Point gradient = sample.gradients[e + 1] - sample.gradients[0];
      rows.row(e) << gradient[0], gradient[1], gradient[2];
      residual[e] = sample.values[0] - sample.values[e + 1];
    }
    const Point  move = SolveDamped(rows, residual);
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
  // Along the line the three indicators stay equal, so it is at right angles to the gradients of their differences.
  return Cross(sample.gradients[1] - sample.gradients[0], sample.gradients[2] - sample.gradients[0]);
}
} // namespace tissue
