/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueLayer.h"

#include "Common/Algorithms.h"
#include "Geometry/NearestPoints.h"
#include "TissueTessellationCore/Tessellation/AnisotropicTessellation.h"
#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
/** The nearest points that tell a plane. */
constexpr std::size_t NumberOfNearest = 8;
/** The nearest points among which those about a point are looked for, all around and above and below. */
constexpr std::size_t NumberAround = 48;
/** The least cosine of the angle from the normal to a point that is above or below, not beside. */
constexpr double CosineOfColumn = 0.8;
/** The nearest points whose planes count at a place; the weights of those beyond are next to none. */
constexpr std::size_t NumberOfPlanes = 16;
/** The nearest points that tell how wide a cell is; six would reach beyond the neighbours at a rim. */
constexpr std::size_t NumberForSpacing = 4;
/** The points, or rim points, that may be nearer to a place than the one whose cell it is taken for. */
constexpr std::size_t NumberOfRivals = 20;
/** How far a cell may reach, in units of its width. */
constexpr double Reach = 1.3;
/** How far neighbours may be in the layer, in units of the width of a cell. */
constexpr double FarthestNeighbor = 2.2;

/** Two axes of the plane of a normal. */
struct PlaneAxes
{
  explicit PlaneAxes(const Point & normal)
  {
    const Point axis = std::abs(normal[0]) < 0.6 ? Point{ { 1.0, 0.0, 0.0 } } : Point{ { 0.0, 1.0, 0.0 } };
    u = Normalized(Cross(normal, axis));
    v = Cross(normal, u);
  }

  Point u;
  Point v;
};

/** The covariance of points about their mean. */
Metric
Covariance(const std::vector<Point> & points)
{
  const double share = 1.0 / static_cast<double>(points.size());
  Point        mean{ { 0.0, 0.0, 0.0 } };
  for (const Point & p : points)
  {
    mean = mean + share * p;
  }
  Metric covariance{ { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
  for (const Point & p : points)
  {
    const Point offset = p - mean;
    int         entry = 0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = i; j < 3; ++j)
      {
        covariance[entry++] += share * offset[i] * offset[j];
      }
    }
  }
  return covariance;
}
} // namespace

TissueLayer::TissueLayer(const std::vector<Point> & points)
  : m_Points(points)
  , m_NumberOfCells(points.size())
  , m_Nearest(FindNearestPoints(points, NumberAround))
  , m_Normals(points.size())
  , m_Flatness(points.size())
  , m_Spacings(points.size())
{
  for (std::size_t i = 0; i < m_NumberOfCells; ++i)
  {
    this->FitPlane(i);
    const std::size_t count = std::min(NumberForSpacing, m_Nearest[i].size());
    for (std::size_t k = 0; k < count; ++k)
    {
      m_Spacings[i] += Distance(points[i], points[m_Nearest[i][k]]) / static_cast<double>(count);
    }
  }
  this->EvenOutSpacings();
  for (std::size_t i = 0; i < m_NumberOfCells; ++i)
  {
    this->CloseRim(i);
  }
  m_Rivals = FindNearestPoints(m_Points, NumberOfRivals);
}

void
TissueLayer::FitPlane(std::size_t point)
{
  std::vector<Point> points{ m_Points[point] };
  for (std::size_t k = 0; k < std::min(NumberOfNearest, m_Nearest[point].size()); ++k)
  {
    points.push_back(m_Points[m_Nearest[point][k]]);
  }
  const SymmetricEigen eigen = DecomposeSymmetric(Covariance(points));
  std::array<int, 3>   order{ { 0, 1, 2 } };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return eigen.values[i] < eigen.values[j]; });
  m_Normals[point] = eigen.vectors[order[0]];
  // Points on a line lie in many planes, of which one is as good as another.
  const double least = std::max(eigen.values[order[0]], 0.0);
  const double middle = eigen.values[order[1]];
  const bool   isLine = middle < 1e-12 * eigen.values[order[2]];
  m_Flatness[point] = isLine ? 0.0 : std::sqrt(least / middle);
}

/** Gives each point the median of its own spacing and those of its nearest. */
void
TissueLayer::EvenOutSpacings()
{
  std::vector<double> even;
  for (std::size_t i = 0; i < m_NumberOfCells; ++i)
  {
    std::vector<double> around{ m_Spacings[i] };
    for (std::size_t k = 0; k < std::min(NumberOfNearest, m_Nearest[i].size()); ++k)
    {
      around.push_back(m_Spacings[m_Nearest[i][k]]);
    }
    even.push_back(Median(std::move(around)));
  }
  m_Spacings = std::move(even);
}

/** Tells whether another point lies beside the point in the layer, rather than above or below it. */
bool
TissueLayer::IsBeside(std::size_t point, std::size_t other) const
{
  const Point offset = m_Points[other] - m_Points[point];
  return std::abs(Dot(m_Normals[point], offset)) < CosineOfColumn * Norm(offset);
}

/** Adds points where the next cells would be, wherever there are no neighbours over a third of the way around. */
void
TissueLayer::CloseRim(std::size_t point)
{
  constexpr double    widestGap = 130.0 / 180.0 * Pi;
  constexpr double    angleOfCell = Pi / 3.0;
  constexpr double    leastDistance = 0.75;
  const PlaneAxes     axes(m_Normals[point]);
  const Point &       p = m_Points[point];
  const double        spacing = m_Spacings[point];
  std::vector<double> angles;
  for (const std::size_t other : m_Nearest[point])
  {
    const Point offset = m_Points[other] - p;
    if (Norm(offset) < FarthestNeighbor * spacing && this->IsBeside(point, other))
    {
      angles.push_back(std::atan2(Dot(axes.v, offset), Dot(axes.u, offset)));
    }
  }
  std::sort(angles.begin(), angles.end());
  if (angles.empty())
  {
    angles.push_back(0.0);
  }
  angles.push_back(angles.front() + 2.0 * Pi);
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
  {
    const double gap = angles[i + 1] - angles[i];
    if (gap < widestGap)
    {
      continue;
    }
    const int parts = std::max(2, static_cast<int>(std::lround(gap / angleOfCell)));
    for (int k = 1; k < parts; ++k)
    {
      const double angle = angles[i] + gap * k / parts;
      const Point  next = p + spacing * (std::cos(angle) * axes.u + std::sin(angle) * axes.v);
      const bool   isFree = std::none_of(m_Nearest[point].begin(), m_Nearest[point].end(), [&](std::size_t other) {
        return Distance(m_Points[other], next) < leastDistance * spacing;
      });
      if (isFree)
      {
        m_Points.push_back(next);
      }
    }
  }
}

/** Tells whether there are points above and below, nearer than four widths and near the normal. */
bool
TissueLayer::IsBetweenOthers(std::size_t point) const
{
  constexpr double farthest = 4.0;
  bool             isBelow = false;
  bool             isAbove = false;
  for (const std::size_t other : m_Nearest[point])
  {
    const Point offset = m_Points[other] - m_Points[point];
    if (Norm(offset) < farthest * m_Spacings[point] && !this->IsBeside(point, other))
    {
      (Dot(m_Normals[point], offset) < 0.0 ? isBelow : isAbove) = true;
    }
  }
  return isBelow && isAbove;
}

bool
TissueLayer::IsEvident() const
{
  const bool  isSmall = m_NumberOfCells <= NumberOfNearest + 1;
  std::size_t flat = 0;
  std::size_t between = 0;
  for (std::size_t i = 0; i < m_NumberOfCells; ++i)
  {
    flat += m_Flatness[i] < (isSmall ? 0.2 : 0.5) ? 1 : 0;
    between += this->IsBetweenOthers(i) ? 1 : 0;
  }
  return 3 * flat >= 2 * m_NumberOfCells && 10 * between < m_NumberOfCells;
}

/** The place of a position near a point, by the mean of the planes of the point and its nearest, the nearer ones more.
 */
TissueLayer::Place
TissueLayer::FindPlace(std::size_t point, const Point & position) const
{
  double     weights = 0.0;
  Place      place{ 0.0, 0.0, { { 0.0, 0.0, 0.0 } } };
  const auto add = [&](std::size_t i) {
    const Point  offset = position - m_Points[i];
    const double weight = std::exp(-2.0 * Dot(offset, offset) / (m_Spacings[point] * m_Spacings[point]));
    const double side = Dot(m_Normals[point], m_Normals[i]) < 0.0 ? -1.0 : 1.0;
    weights += weight;
    place.height += side * weight * Dot(m_Normals[i], offset);
    place.depth += 0.5 * weight * m_Spacings[i];
    place.normal = place.normal + side * weight * m_Normals[i];
  };
  add(point);
  for (std::size_t k = 0; k < std::min(NumberOfPlanes, m_Nearest[point].size()); ++k)
  {
    if (this->IsBeside(point, m_Nearest[point][k]))
    {
      add(m_Nearest[point][k]);
    }
  }
  return { place.height / weights, place.depth / weights, Normalized(place.normal) };
}

/** The point in the middle of the layer on whose normal the position is: the same one for all of a normal. */
Point
TissueLayer::FindFoot(std::size_t point, const Point & position) const
{
  constexpr int numberOfSteps = 2;
  Point         foot = position;
  for (int step = 0; step < numberOfSteps; ++step)
  {
    const Place place = this->FindPlace(point, foot);
    const Point middle = foot - place.height * place.normal;
    const Point offset = position - middle;
    foot = position - Dot(offset, place.normal) * place.normal;
  }
  return foot;
}

/** Whether the position is in the cell of the point, as far as one tells from its neighbours. */
bool
TissueLayer::IsInTissue(std::size_t point, const Point & position) const
{
  const Place place = this->FindPlace(point, position);
  if (std::abs(place.height) > place.depth)
  {
    return false;
  }
  const double distance = Distance(position, m_Points[point]);
  return std::none_of(m_Rivals[point].begin(), m_Rivals[point].end(), [&](std::size_t other) {
    return Distance(position, m_Points[other]) < distance;
  });
}

TissueMask
TissueLayer::MakeMask(const TissueGrid & grid, const Execution & execution) const
{
  TissueMask mask{ grid, std::vector<std::uint8_t>(grid.NumberOfPoints(), 0) };
  const auto rangeOf = [&](int axis, double center, double reach) {
    const double middle = (center - grid.lower[axis]) / grid.steps[axis] - 0.5;
    const double last = grid.size[axis] - 1.0;
    return std::pair(static_cast<std::int32_t>(std::clamp(std::ceil(middle - reach / grid.steps[axis]), 0.0, last)),
                     static_cast<std::int32_t>(std::clamp(std::floor(middle + reach / grid.steps[axis]), 0.0, last)));
  };
  execution.For(static_cast<std::size_t>(grid.size[2]), [&](std::size_t plane) {
    const auto   z = static_cast<std::int32_t>(plane);
    const double height = grid.Position(0, 0, z)[2];
    for (std::size_t i = 0; i < m_NumberOfCells; ++i)
    {
      const double offset = height - m_Points[i][2];
      const double reach = Reach * m_Spacings[i];
      if (std::abs(offset) >= reach)
      {
        continue;
      }
      const double radius = std::sqrt(reach * reach - offset * offset);
      const auto   rangeX = rangeOf(0, m_Points[i][0], radius);
      const auto   rangeY = rangeOf(1, m_Points[i][1], radius);
      for (std::int32_t y = rangeY.first; y <= rangeY.second; ++y)
      {
        for (std::int32_t x = rangeX.first; x <= rangeX.second; ++x)
        {
          std::uint8_t & inside = mask.inside[grid.Offset(x, y, z)];
          inside = inside != 0 || this->IsInTissue(i, grid.Position(x, y, z)) ? 1 : 0;
        }
      }
    }
  });
  return mask;
}

double
TissueLayer::Thickness() const
{
  return Median(m_Spacings);
}

TissueSamples
TissueLayer::Flatten(TissueSamples samples, const Execution & execution) const
{
  std::vector<MetricSeed> seeds;
  for (std::size_t i = 0; i < m_NumberOfCells; ++i)
  {
    seeds.push_back({ m_Points[i] });
  }
  const auto owners = AssignSamples(AnisotropicTessellation(std::move(seeds)), samples, execution);
  // In loops over the groups of samples, whose balls grow by as much as their samples move.
  execution.For(samples.groups.size(), [&](std::size_t k) {
    double            farthest = 0.0;
    const std::size_t begin = k == 0 ? 0 : samples.groups[k - 1].end;
    for (std::size_t i = begin; i < samples.groups[k].end; ++i)
    {
      const Point flat = this->FindFoot(static_cast<std::size_t>(owners[i]), samples.points[i]);
      farthest = std::max(farthest, Distance(flat, samples.points[i]));
      samples.points[i] = flat;
    }
    samples.groups[k].radius += farthest;
  });
  return samples;
}

} // namespace tissue
