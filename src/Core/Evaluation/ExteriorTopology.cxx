/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/ExteriorTopology.h"

#include "Nerve/KuhnSimplex.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

namespace tissue
{
namespace
{
/** For each pattern of cells and exterior in a block of 2x2x2 voxels, a bit a voxel with the first axis fastest. */
using PatternTable = std::array<std::int32_t, 256>;

/** What the simplices that begin at the block's first voxel add to the Euler characteristic of the boundary. It cuts
 * each simplex that has vertices on both of its sides: an edge in a point, a triangle in an edge, a tetrahedron in a
 * face. */
PatternTable
MakeEulerTable()
{
  std::set<unsigned> simplices;
  for (int way = 0; way < 9; ++way)
  {
    if (way / 3 == way % 3)
    {
      continue;
    }
    const KuhnSimplex tetrahedron = KuhnSimplex::FromWay({ { 0, 0, 0 } }, way / 3, way % 3);
    for (unsigned others = 1; others < 8; ++others)
    {
      unsigned simplex = 1;
      for (int i = 0; i < 3; ++i)
      {
        const VoxelIndex & voxel = tetrahedron.voxels[i + 1];
        simplex |= (others >> i & 1u) << (voxel[0] + 2 * voxel[1] + 4 * voxel[2]);
      }
      simplices.insert(simplex);
    }
  }
  PatternTable table{};
  for (unsigned pattern = 0; pattern < table.size(); ++pattern)
  {
    for (const unsigned simplex : simplices)
    {
      const unsigned cells = pattern & simplex;
      if (cells != 0 && cells != simplex)
      {
        table[pattern] += std::bitset<8>(simplex).count() == 3 ? -1 : 1;
      }
    }
  }
  return table;
}

/** A plane of voxels with a border of one voxel of exterior: which of them are of cells. */
struct TissuePlane
{
  std::size_t               width;
  std::size_t               height;
  std::vector<std::uint8_t> isCell;
};

TissuePlane
ReadTissuePlane(const LabelVolume & volume, std::int32_t z)
{
  TissuePlane plane{ static_cast<std::size_t>(volume.size[0]) + 2, static_cast<std::size_t>(volume.size[1]) + 2, {} };
  plane.isCell.assign(plane.width * plane.height, 0);
  if (z < 0 || z >= volume.size[2])
  {
    return plane;
  }
  auto voxel = static_cast<std::size_t>(z) * volume.size[1] * volume.size[0];
  for (std::size_t y = 1; y + 1 < plane.height; ++y)
  {
    for (std::size_t x = 1; x + 1 < plane.width; ++x)
    {
      plane.isCell[y * plane.width + x] = volume.vertices[voxel++] != ExteriorVertex ? 1 : 0;
    }
  }
  return plane;
}

/** Sums up the table over the blocks between two planes. */
std::int64_t
SumBlocks(const TissuePlane & lower, const TissuePlane & upper, const PatternTable & table)
{
  std::int64_t sum = 0;
  for (std::size_t row = 0; row + lower.width < lower.isCell.size(); row += lower.width)
  {
    // The bits of the four voxels at one place along the row, where a block has its first ones.
    const auto column = [&](std::size_t x) {
      const std::size_t p = row + x;
      return lower.isCell[p] | lower.isCell[p + lower.width] << 2 | upper.isCell[p] << 4 |
             upper.isCell[p + lower.width] << 6;
    };
    int last = column(0);
    for (std::size_t x = 1; x < lower.width; ++x)
    {
      const int next = column(x);
      sum += table[static_cast<std::size_t>(last | next << 1)];
      last = next;
    }
  }
  return sum;
}

/** Voxels of a row that are of cells, or of the exterior, without a gap. */
struct Run
{
  std::int32_t first;
  std::int32_t last;
  bool         isCell;
};

/** The runs of a plane, row after row, and where the rows begin. */
struct PlaneRuns
{
  std::vector<Run>         runs;
  std::vector<std::size_t> firstOfRow{ 0 };
};

PlaneRuns
FindRuns(const TissuePlane & plane)
{
  PlaneRuns result;
  for (std::size_t row = 0; row < plane.isCell.size(); row += plane.width)
  {
    for (std::size_t x = 0; x < plane.width; ++x)
    {
      const bool isCell = plane.isCell[row + x] != 0;
      if (x == 0 || result.runs.back().isCell != isCell)
      {
        result.runs.push_back({ static_cast<std::int32_t>(x), 0, isCell });
      }
      result.runs.back().last = static_cast<std::int32_t>(x);
    }
    result.firstOfRow.push_back(result.runs.size());
  }
  return result;
}

std::int64_t
CountSets(DisjointSets & sets)
{
  std::int64_t number = 0;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(sets.GetSize()); ++i)
  {
    number += sets.Find(i) == i ? 1 : 0;
  }
  return number;
}

/** \brief Joins the runs of neighbouring rows to pieces of the tissue and of the exterior. */
class PieceCount
{
public:
  explicit PieceCount(const std::vector<PlaneRuns> & planes)
    : m_Planes(planes)
  {
    for (const PlaneRuns & plane : planes)
    {
      m_Offsets.push_back(m_Offsets.back() + plane.runs.size());
    }
    m_Sets = DisjointSets(m_Offsets.back());
    const std::size_t rows = planes.front().firstOfRow.size() - 1;
    for (std::size_t z = 0; z < planes.size(); ++z)
    {
      for (std::size_t y = 0; y < rows; ++y)
      {
        this->JoinRows(z, y, z, y + 1);
        this->JoinRows(z, y, z + 1, y);
        this->JoinRows(z, y, z + 1, y + 1);
      }
    }
  }

  std::int64_t
  GetNumberOfPieces()
  {
    return CountSets(m_Sets);
  }

private:
  /** A voxel of the first row hangs together with the voxel at the same place of the second row and with the next one.
   */
  void
  JoinRows(std::size_t z, std::size_t y, std::size_t otherZ, std::size_t otherY)
  {
    if (otherZ >= m_Planes.size() || otherY + 1 >= m_Planes[otherZ].firstOfRow.size())
    {
      return;
    }
    const PlaneRuns & plane = m_Planes[z];
    const PlaneRuns & otherPlane = m_Planes[otherZ];
    const std::size_t end = otherPlane.firstOfRow[otherY + 1];
    std::size_t       begin = otherPlane.firstOfRow[otherY];
    for (std::size_t i = plane.firstOfRow[y]; i < plane.firstOfRow[y + 1]; ++i)
    {
      const Run & run = plane.runs[i];
      while (otherPlane.runs[begin].last < run.first)
      {
        ++begin;
      }
      for (std::size_t j = begin; j < end && otherPlane.runs[j].first <= run.last + 1; ++j)
      {
        if (otherPlane.runs[j].isCell == run.isCell)
        {
          m_Sets.Unite(static_cast<std::int64_t>(m_Offsets[z] + i), static_cast<std::int64_t>(m_Offsets[otherZ] + j));
        }
      }
    }
  }

  const std::vector<PlaneRuns> & m_Planes;
  std::vector<std::size_t>       m_Offsets{ 0 };
  DisjointSets                   m_Sets;
};

/** An edge of a triangle, with the lower one of its points first, and the triangle's two corners there: corner 3 t + i
 * is point i of triangle t. */
struct CornerEdge
{
  std::array<PointId, 2>      points;
  std::array<std::int64_t, 2> corners;
  /** Whether the triangle, seen from the exterior, runs from the lower point to the other one. */
  bool isUpwards;
};

/** The edges of the triangles at the exterior, equal ones side by side. */
std::vector<CornerEdge>
CollectExteriorEdges(const WallMesh & walls)
{
  std::vector<CornerEdge> edges;
  std::int64_t            triangle = 0;
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    const VertexPair & cells = walls.walls[walls.wallOfTriangle[t]].cells;
    if (cells[0] != ExteriorVertex && cells[1] != ExteriorVertex)
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      CornerEdge edge{ { { walls.triangles[t][i], walls.triangles[t][(i + 1) % 3] } },
                       { { 3 * triangle + i, 3 * triangle + (i + 1) % 3 } },
                       cells[1] == ExteriorVertex };
      if (edge.points[1] < edge.points[0])
      {
        std::swap(edge.points[0], edge.points[1]);
        std::swap(edge.corners[0], edge.corners[1]);
        edge.isUpwards = !edge.isUpwards;
      }
      edges.push_back(edge);
    }
    ++triangle;
  }
  std::sort(edges.begin(), edges.end(), [](const CornerEdge & a, const CornerEdge & b) {
    return std::tie(a.points, a.corners) < std::tie(b.points, b.corners);
  });
  return edges;
}

/** Whether there are edges, and each is there twice, in opposite directions. */
bool
AreClosed(const std::vector<CornerEdge> & edges)
{
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    if (i + 1 == edges.size() || edges[i].points != edges[i + 1].points ||
        edges[i].isUpwards == edges[i + 1].isUpwards || (i > 0 && edges[i].points == edges[i - 1].points))
    {
      return false;
    }
  }
  return !edges.empty();
}
} // namespace

SurfaceTopology
FindExteriorTopology(const LabelVolume & labels, const Execution & execution)
{
  const PatternTable        table = MakeEulerTable();
  const auto                numberOfPlanes = static_cast<std::size_t>(labels.size[2]) + 2;
  std::vector<PlaneRuns>    runs(numberOfPlanes);
  std::vector<std::int64_t> sums(numberOfPlanes);
  execution.For(numberOfPlanes, [&](std::size_t i) {
    const auto        z = static_cast<std::int32_t>(i) - 1;
    const TissuePlane plane = ReadTissuePlane(labels, z);
    runs[i] = FindRuns(plane);
    sums[i] = SumBlocks(plane, ReadTissuePlane(labels, z + 1), table);
  });

  SurfaceTopology topology;
  topology.isClosed = true;
  topology.eulerCharacteristic = std::accumulate(sums.begin(), sums.end(), std::int64_t{ 0 });
  // Each piece of the boundary parts space in two, so that the pieces on its sides, joined by it, are a tree.
  topology.numberOfPieces = PieceCount(runs).GetNumberOfPieces() - 1;
  return topology;
}

SurfaceTopology
FindExteriorTopology(const WallMesh & walls)
{
  const std::vector<CornerEdge> edges = CollectExteriorEdges(walls);
  SurfaceTopology               topology;
  topology.isClosed = AreClosed(edges);
  if (!topology.isClosed)
  {
    return topology;
  }
  // There are as many corners as edges of triangles. Those of one point of the surface are joined edge by edge around
  // it.
  DisjointSets points(edges.size());
  DisjointSets pieces(edges.size() / 3);
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    const auto & [a, b] = std::tie(edges[i].corners, edges[i + 1].corners);
    points.Unite(a[0], b[0]);
    points.Unite(a[1], b[1]);
    pieces.Unite(a[0] / 3, b[0] / 3);
  }
  const auto numberOfEdges = static_cast<std::int64_t>(edges.size()) / 2;
  topology.numberOfPieces = CountSets(pieces);
  topology.eulerCharacteristic = CountSets(points) - numberOfEdges + static_cast<std::int64_t>(edges.size()) / 3;
  return topology;
}
} // namespace tissue
