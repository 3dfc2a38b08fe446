/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/TriangleImprovement.h"

#include "Mesh/WallLines.h"
#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <algorithm>
#include <limits>

namespace tissue
{
namespace
{
/** The number of steps that are tried, each half of the one before: 1/4 to 1/64. Shorter ones would gain little. */
constexpr int LineSearchSteps = 5;
/** The longest step, in lengths of the shortest edge at the point. Longer ones more often turn a triangle over. */
constexpr double FirstStep = 0.25;

/** \brief The moves of one sweep, with the triangles at each point in compressed rows: those of point p are at
 * m_First[p] .. m_First[p + 1] of m_Triangles. */
class Improvement
{
public:
  explicit Improvement(WallMesh & mesh);

  void
  Sweep(const Execution & execution);

private:
  /** The corners of a triangle, beginning with the point that is to move. */
  using Corners = std::array<Point, 3>;

  template <typename TFunction>
  void
  ForEachTriangle(PointId point, TFunction function) const
  {
    for (const std::int32_t i : m_Triangles[static_cast<std::size_t>(point)])
    {
      const auto & t = m_Mesh.triangles[i / 3];
      const int    k = i % 3;
      function(Corners{ { m_Mesh.points[t[k]], m_Mesh.points[t[(k + 1) % 3]], m_Mesh.points[t[(k + 2) % 3]] } });
    }
  }

  void
  MoveWithinWall(PointId point);
  void
  MoveAlongLine(const WallLine & line, std::size_t i);
  void
  SearchAlong(PointId point, const Point & direction);
  bool
  TryMove(PointId point, const Point & target, double distortion);

  WallMesh &                        m_Mesh;
  std::vector<WallLine>             m_Lines;
  std::vector<std::vector<PointId>> m_PointsWithin;
  /** The row of a point has an entry for each triangle at it: three times the triangle's index, plus the place of the
   * point in it. */
  CompressedRows<std::int32_t, std::int32_t> m_Triangles;
};

Improvement::Improvement(WallMesh & mesh)
  : m_Mesh(mesh)
  , m_Lines(CollectWallLines(mesh))
  , m_PointsWithin(mesh.walls.size())
{
  const auto visitCorners = [&mesh](const auto & visit) {
    for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i)
    {
      visit(static_cast<std::size_t>(mesh.triangles[i / 3][i % 3]), static_cast<std::int32_t>(i));
    }
  };
  m_Triangles.Assign(mesh.points.size(), visitCorners);
  visitCorners([&](std::size_t p, std::int32_t i) {
    if (mesh.numberOfCells[p] == CellsWithinWall && *m_Triangles[p].begin() == i)
    {
      m_PointsWithin[mesh.wallOfTriangle[i / 3]].push_back(static_cast<PointId>(p));
    }
  });
}

void
Improvement::Sweep(const Execution & execution)
{
  execution.For(m_PointsWithin.size(), [this](std::size_t wall) {
    for (const PointId p : m_PointsWithin[wall])
    {
      this->MoveWithinWall(p);
    }
  });
  // A triangle can join points of two lines, so that lines are not worked on in parallel.
  for (const WallLine & line : m_Lines)
  {
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
    {
      this->MoveAlongLine(line, i);
    }
  }
}

bool
Improvement::TryMove(PointId point, const Point & target, double distortion)
{
  double moved = 0.0;
  bool   upright = true;
  this->ForEachTriangle(point, [&](const Corners & t) {
    const Point before = Cross(t[1] - t[0], t[2] - t[0]);
    const Point after = Cross(t[1] - target, t[2] - target);
    upright = upright && Dot(before, after) > 0.0;
    moved += TriangleDistortion(target, t[1], t[2]);
  });
  if (upright && moved < distortion)
  {
    m_Mesh.points[point] = target;
    return true;
  }
  return false;
}

void
Improvement::SearchAlong(PointId point, const Point & direction)
{
  double distortion = 0.0;
  double shortest = std::numeric_limits<double>::infinity();
  this->ForEachTriangle(point, [&](const Corners & t) {
    distortion += TriangleDistortion(t[0], t[1], t[2]);
    shortest = std::min({ shortest, Distance(t[0], t[1]), Distance(t[0], t[2]) });
  });
  double step = FirstStep * shortest;
  for (int i = 0; i < LineSearchSteps; ++i, step *= 0.5)
  {
    if (this->TryMove(point, m_Mesh.points[point] + step * direction, distortion))
    {
      return;
    }
  }
}

void
Improvement::MoveWithinWall(PointId point)
{
  Point gradient{ { 0.0, 0.0, 0.0 } };
  Point normal{ { 0.0, 0.0, 0.0 } };
  this->ForEachTriangle(point, [&](const Corners & t) {
    gradient = gradient + TriangleDistortionGradient(t[0], t[1], t[2]);
    normal = normal + Cross(t[1] - t[0], t[2] - t[0]);
  });
  // The steepest descent within the tangent plane is the gradient's part along the normal less the gradient.
  normal = Normalized(normal);
  this->SearchAlong(point, Normalized(Dot(gradient, normal) * normal - gradient));
}

void
Improvement::MoveAlongLine(const WallLine & line, std::size_t i)
{
  const PointId point = line.points[i];
  const Point   chord = Normalized(m_Mesh.points[line.points[i + 1]] - m_Mesh.points[line.points[i - 1]]);
  Point         gradient{ { 0.0, 0.0, 0.0 } };
  this->ForEachTriangle(point,
                        [&](const Corners & t) { gradient = gradient + TriangleDistortionGradient(t[0], t[1], t[2]); });
  this->SearchAlong(point, (Dot(gradient, chord) > 0.0 ? -1.0 : 1.0) * chord);
}
} // namespace

void
ImproveTriangles(WallMesh & mesh, int sweeps, const Execution & execution)
{
  Improvement improvement(mesh);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    improvement.Sweep(execution);
  }
}
} // namespace tissue
