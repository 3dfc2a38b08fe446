/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Remeshing/LineCoarsening.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Geometry/TriangleQuality.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** The distortion that a triangle may have after a change, unless it had more before; it has no unit, and 100 is that
 * of a quality of 0.1. A lower limit would keep more points on lines than wanted, a higher one would leave needles,
 * which the remeshing of the wall cannot mend where their points are on its outline. */
constexpr double MostDistortion = 100.0;

bool
Holds(const Triangle & triangle, PointId point)
{
  return triangle[0] == point || triangle[1] == point || triangle[2] == point;
}

Point
NormalOf(const std::array<Point, 3> & t)
{
  return Cross(t[1] - t[0], t[2] - t[0]);
}
} // namespace

LineCoarsening::LineCoarsening(WallMesh & mesh)
  : m_Mesh(mesh)
  , m_WallsAt(mesh)
  , m_TrianglesAt(mesh.points.size())
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      if (mesh.numberOfCells[p] >= CellsOnLine)
      {
        m_TrianglesAt[p].push_back(static_cast<std::int32_t>(t));
      }
    }
  }
}

bool
LineCoarsening::CanBeAt(PointId point, const Point & target, PointId except) const
{
  for (const std::int32_t t : m_TrianglesAt[point])
  {
    const auto & triangle = m_Mesh.triangles[t];
    if (Holds(triangle, except))
    {
      continue;
    }
    std::array<Point, 3> before;
    std::array<Point, 3> after;
    for (int i = 0; i < 3; ++i)
    {
      before[i] = m_Mesh.points[triangle[i]];
      after[i] = triangle[i] == point ? target : before[i];
    }
    const double most = std::max(MostDistortion, TriangleDistortion(before[0], before[1], before[2]));
    if (!(Dot(NormalOf(before), NormalOf(after)) > 0.0) || !(TriangleDistortion(after[0], after[1], after[2]) <= most))
    {
      return false;
    }
  }
  return true;
}

std::vector<PointId>
LineCoarsening::NeighborsIn(WallId wall, PointId point) const
{
  std::vector<PointId> neighbors;
  for (const std::int32_t t : m_TrianglesAt[point])
  {
    if (m_Mesh.wallOfTriangle[t] == wall)
    {
      for (const PointId p : m_Mesh.triangles[t])
      {
        if (p != point)
        {
          neighbors.push_back(p);
        }
      }
    }
  }
  SortUnique(neighbors);
  return neighbors;
}

// The link condition of an edge collapse, on the outline of one wall: the edge from `point` to `into` has one triangle
// there, so that the two may have one neighbour in common, the third point of that triangle. A second one would leave
// two triangles on the same edge. The other neighbours of `point` become neighbours of `into` by new edges. Such an
// edge to a point of the outline cuts the wall in two, which it may only where no other wall can have the same edge:
// where this wall is the only one that has both points. The edge to `other`, along the line, is meant to be all three
// walls'.
bool
LineCoarsening::WallCanMerge(WallId wall, PointId point, PointId into, PointId other) const
{
  const std::vector<PointId> ofPoint = this->NeighborsIn(wall, point);
  const std::vector<PointId> ofInto = this->NeighborsIn(wall, into);
  std::vector<PointId>       common;
  std::set_intersection(ofPoint.begin(), ofPoint.end(), ofInto.begin(), ofInto.end(), std::back_inserter(common));
  // With two neighbours the point is in one triangle, without which the wall would have no edge there.
  if (common.size() != 1 || ofPoint.size() < 3)
  {
    return false;
  }
  return std::all_of(ofPoint.begin(), ofPoint.end(), [&](PointId p) {
    const bool isNew = p != into && p != other && p != common[0];
    return !isNew || m_Mesh.numberOfCells[p] == CellsWithinWall || m_WallsAt.CountCommon(p, into) == 1;
  });
}

bool
LineCoarsening::CanMerge(PointId point, PointId into, PointId other) const
{
  std::vector<WallId> walls;
  for (const std::int32_t t : m_TrianglesAt[point])
  {
    walls.push_back(m_Mesh.wallOfTriangle[t]);
  }
  SortUnique(walls);
  return std::all_of(
           walls.begin(), walls.end(), [&](WallId wall) { return this->WallCanMerge(wall, point, into, other); }) &&
         this->CanBeAt(point, m_Mesh.points[into], into);
}

// A triangle with both points vanishes, and is forgotten by its other points; those with `point` alone get `into`
// instead.
void
LineCoarsening::Merge(PointId point, PointId into)
{
  for (const std::int32_t t : m_TrianglesAt[point])
  {
    auto & triangle = m_Mesh.triangles[t];
    if (Holds(triangle, into))
    {
      for (const PointId p : triangle)
      {
        auto & at = m_TrianglesAt[p];
        if (p != point && !at.empty())
        {
          at.erase(std::find(at.begin(), at.end(), t));
        }
      }
      triangle.fill(into);
    }
    else
    {
      std::replace(triangle.begin(), triangle.end(), point, into);
      m_TrianglesAt[into].push_back(t);
    }
  }
  m_TrianglesAt[point].clear();
  m_Mesh.numberOfCells[point] = 0;
}

bool
LineCoarsening::RemovePoint(WallLine & line, std::size_t i)
{
  const PointId point = line.points[i];
  PointId       nearer = line.points[i - 1];
  PointId       farther = line.points[i + 1];
  if (Distance(m_Mesh.points[point], m_Mesh.points[farther]) < Distance(m_Mesh.points[point], m_Mesh.points[nearer]))
  {
    std::swap(nearer, farther);
  }
  for (const PointId into : { nearer, farther })
  {
    if (this->CanMerge(point, into, into == nearer ? farther : nearer))
    {
      this->Merge(point, into);
      line.points.erase(line.points.begin() + static_cast<std::ptrdiff_t>(i));
      return true;
    }
  }
  return false;
}

bool
LineCoarsening::MovePoint(PointId point, const Point & target)
{
  constexpr PointId none = -1;
  if (!this->CanBeAt(point, target, none))
  {
    return false;
  }
  m_Mesh.points[point] = target;
  return true;
}
} // namespace tissue
