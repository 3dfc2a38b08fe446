/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/KuhnWall.h"

#include <algorithm>
#include <iterator>

namespace tissue
{
namespace
{
int
SumOf(const VoxelIndex & p)
{
  return p[0] + p[1] + p[2];
}

VoxelIndex
Difference(const VoxelIndex & a, const VoxelIndex & b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

bool
AreNeighbors(const VoxelIndex & a, const VoxelIndex & b)
{
  const VoxelIndex d = Difference(a, b);
  const auto [least, most] = std::minmax({ d[0], d[1], d[2] });
  return (least >= 0 && most == 1) || (most <= 0 && least == -1);
}

/** The step from a voxel to a neighbour that follows it, as a set of axes. */
int
SetOf(const VoxelIndex & step)
{
  return step[0] + 2 * step[1] + 4 * step[2];
}

/** The steps from the first voxel of an edge to the third ones of the triangles around it. */
using StepsAround = std::vector<VoxelIndex>;

/** By the step along the edge, in the order of KuhnSteps(). */
const std::array<StepsAround, 14> &
AllStepsAround()
{
  static const std::array<StepsAround, 14> all = [] {
    std::array<StepsAround, 14> around;
    for (std::size_t along = 0; along < around.size(); ++along)
    {
      std::copy_if(KuhnSteps().begin(),
                   KuhnSteps().end(),
                   std::back_inserter(around[along]),
                   [along](const VoxelIndex & step) { return AreNeighbors(step, KuhnSteps()[along]); });
    }
    return around;
  }();
  return all;
}

const StepsAround &
StepsAroundEdge(const KuhnEdge & edge)
{
  const int set = SetOf(Difference(edge.second, edge.first));
  return AllStepsAround()[static_cast<std::size_t>(set > 0 ? set - 1 : 6 - set)];
}

/** One of the two tetrahedra that have a triangle, with the local vertex that is not of it. */
std::pair<KuhnSimplex, int>
TetrahedronOf(const std::array<VoxelIndex, 3> & triangle)
{
  for (const VoxelIndex & step : KuhnSteps())
  {
    const VoxelIndex fourth = triangle[0] + step;
    if (AreNeighbors(fourth, triangle[1]) && AreNeighbors(fourth, triangle[2]))
    {
      KuhnSimplex simplex{ { triangle[0], triangle[1], triangle[2], fourth } };
      // The order of the way from the first voxel to the last one.
      std::sort(simplex.voxels.begin(), simplex.voxels.end(), [](const VoxelIndex & a, const VoxelIndex & b) {
        return SumOf(a) < SumOf(b);
      });
      const auto at = std::find(simplex.voxels.begin(), simplex.voxels.end(), fourth);
      return { simplex, static_cast<int>(at - simplex.voxels.begin()) };
    }
  }
  return {}; // every triangle has two
}

std::int64_t
KeyOfTriangle(const LabelVolume & volume, const KuhnSimplex & simplex, int opposite)
{
  std::array<VoxelIndex, 3> triangle;
  for (int i = 0, k = 0; i < 4; ++i)
  {
    if (i != opposite)
    {
      triangle[k++] = simplex.voxels[i];
    }
  }
  std::sort(triangle.begin(), triangle.end(), [](const auto & a, const auto & b) { return SumOf(a) < SumOf(b); });
  return 64 * KeyOfVoxel(volume, triangle[0]) + 8 * SetOf(Difference(triangle[1], triangle[0])) +
         SetOf(Difference(triangle[2], triangle[0]));
}
} // namespace

std::int64_t
KeyOfVoxel(const LabelVolume & volume, const VoxelIndex & p)
{
  return (static_cast<std::int64_t>(p[2] + 2) * (volume.size[1] + 4) + p[1] + 2) * (volume.size[0] + 4) + p[0] + 2;
}

const std::array<VoxelIndex, 14> &
KuhnSteps()
{
  static const std::array<VoxelIndex, 14> steps = [] {
    std::array<VoxelIndex, 14> all;
    for (int set = 1; set < 8; ++set)
    {
      const VoxelIndex step{ { set & 1, set >> 1 & 1, set >> 2 } };
      all[set - 1] = step;
      all[set + 6] = { { -step[0], -step[1], -step[2] } };
    }
    return all;
  }();
  return steps;
}

std::int64_t
KuhnWallSearch::KeyOf(const KuhnEdge & edge) const
{
  const bool         isAscending = SumOf(edge.first) < SumOf(edge.second);
  const VoxelIndex & first = isAscending ? edge.first : edge.second;
  const VoxelIndex & second = isAscending ? edge.second : edge.first;
  return 8 * KeyOfVoxel(m_Volume, first) + SetOf(Difference(second, first));
}

std::optional<KuhnWall>
KuhnWallSearch::Find(const KuhnEdge & start)
{
  if (!m_Found.Insert(this->KeyOf(start)))
  {
    return std::nullopt;
  }
  KuhnWall wall;
  wall.cells = { { this->At(start.first), this->At(start.second) } };
  wall.start = start;
  m_Walked.Clear();
  m_Open.assign(1, start);
  while (!m_Open.empty())
  {
    const KuhnEdge edge = m_Open.back();
    m_Open.pop_back();
    this->Visit(edge, wall);
  }
  return wall;
}

void
KuhnWallSearch::Visit(const KuhnEdge & edge, KuhnWall & wall)
{
  wall.voxels[0].push_back(edge.first);
  wall.voxels[1].push_back(edge.second);
  for (const VoxelIndex & step : StepsAroundEdge(edge))
  {
    const VoxelIndex third = edge.first + step;
    const VertexId   label = this->At(third);
    if (label != wall.cells[0] && label != wall.cells[1])
    {
      this->WalkCircle(edge, third, wall);
      continue;
    }
    const KuhnEdge next = label == wall.cells[0] ? KuhnEdge{ third, edge.second } : KuhnEdge{ edge.first, third };
    if (m_Found.Insert(this->KeyOf(next)))
    {
      m_Open.push_back(next);
    }
  }
}

void
KuhnWallSearch::WalkCircle(const KuhnEdge & edge, const VoxelIndex & third, KuhnWall & wall)
{
  auto [simplex, exit] = TetrahedronOf({ { edge.first, edge.second, third } });
  std::array<VertexId, 4> labels;
  std::transform(
    simplex.voxels.begin(), simplex.voxels.end(), labels.begin(), [this](const VoxelIndex & p) { return this->At(p); });
  bool hasCorners = false;
  if (m_Walked.Contains(KeyOfTriangle(m_Volume, simplex, exit)))
  {
    return;
  }
  while (m_Walked.Insert(KeyOfTriangle(m_Volume, simplex, exit)))
  {
    simplex.Pivot(exit);
    const int entry = exit;
    labels[entry] = this->At(simplex.voxels[entry]);
    // Of three labels two vertices have one in common: the boundary leaves through the triangle that the earlier of
    // them is not in. Of four it leaves along the line of the wall's two cells and the new one.
    for (int j = 0; j < 4; ++j)
    {
      if (j != entry && labels[j] == labels[entry])
      {
        exit = j;
      }
    }
    if (exit == entry)
    {
      hasCorners = true;
      exit = 0;
      while (exit == entry || labels[exit] == wall.cells[0] || labels[exit] == wall.cells[1])
      {
        ++exit;
      }
    }
  }
  if (hasCorners)
  {
    ++wall.numberOfCircles;
  }
  else
  {
    wall.closedLines.push_back({ edge, third });
  }
}
} // namespace tissue
