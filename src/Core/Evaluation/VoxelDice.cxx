/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Evaluation/VoxelDice.h"

#include "Geometry/ExactPredicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tissue
{
namespace
{
/** The whole numbers from first to last; none where last < first. */
struct Range
{
  std::int64_t first;
  std::int64_t last;
};

/** Gives the whole numbers in lower .. upper that are indices of a grid of this size. */
Range
Within(double lower, double upper, std::int32_t size)
{
  const double last = static_cast<double>(size) - 1.0;
  return { static_cast<std::int64_t>(std::ceil(std::clamp(lower, 0.0, last + 1.0))),
           static_cast<std::int64_t>(std::floor(std::clamp(upper, -1.0, last))) };
}

/** Tells on which side of the line from a to b the row at (y, z) is, seen along the rows: 1 or -1, or 0 where a and b
 * look like one point. A row on the line is taken for one a little farther along y, and far less along z. */
int
SideOfRow(const Point & a, const Point & b, double y, double z)
{
  // Relative to the sum of the two products, the error of their difference is at most about 3.3e-16 (J. R. Shewchuk
  // 1997, doi:10.1007/PL00009321). Where the difference is within three times that, the exact predicate decides.
  constexpr double bound = 1e-15;
  const double     ahead = (b[1] - a[1]) * (z - a[2]);
  const double     aside = (b[2] - a[2]) * (y - a[1]);
  int              side = ahead > aside ? 1 : -1;
  if (std::abs(ahead - aside) <= bound * (std::abs(ahead) + std::abs(aside)))
  {
    side = Orientation({ { 0.0, a[1], a[2] } }, { { 0.0, b[1], b[2] } }, { { 0.0, y, z } }, { { 1.0, y, z } });
  }
  if (side == 0)
  {
    side = b[2] != a[2] ? (b[2] < a[2] ? 1 : -1) : (b[1] > a[1]) - (b[1] < a[1]);
  }
  return side;
}

/** \brief Where the triangles of a cell cross the rows of voxels. */
class RowCrossings
{
public:
  explicit RowCrossings(const std::array<std::int32_t, 3> & size)
    : m_Size(size)
  {}

  /** Adds where the rows meet a triangle, which is in the coordinates of the voxels' indices. */
  void
  AddTriangle(const Point & a, const Point & b, const Point & c)
  {
    const auto y = Within(std::min({ a[1], b[1], c[1] }), std::max({ a[1], b[1], c[1] }), m_Size[1]);
    const auto z = Within(std::min({ a[2], b[2], c[2] }), std::max({ a[2], b[2], c[2] }), m_Size[2]);
    for (std::int64_t k = z.first; k <= z.last; ++k)
    {
      for (std::int64_t j = y.first; j <= y.last; ++j)
      {
        const auto v = static_cast<double>(j);
        const auto w = static_cast<double>(k);
        const int  side = SideOfRow(a, b, v, w);
        if (side != 0 && SideOfRow(b, c, v, w) == side && SideOfRow(c, a, v, w) == side)
        {
          m_Crossings.emplace_back(k * m_Size[1] + j, PlaceOnRow(a, b, c, v, w));
        }
      }
    }
  }

  /** Calls visit(row, range) for the voxels between each two crossings of a row. */
  template <typename TVisitor>
  void
  VisitWithin(const TVisitor & visit)
  {
    std::sort(m_Crossings.begin(), m_Crossings.end());
    for (std::size_t i = 0; i + 1 < m_Crossings.size(); ++i)
    {
      if (m_Crossings[i].first == m_Crossings[i + 1].first)
      {
        // A centre at a crossing counts as before it, in the cells on both sides of the wall, so that one of them has
        // it.
        const double end = static_cast<double>(m_Size[0]);
        const double from = std::floor(std::clamp(m_Crossings[i].second, -1.0, end)) + 1.0;
        visit(m_Crossings[i].first, Within(from, m_Crossings[i + 1].second, m_Size[0]));
        ++i;
      }
    }
  }

private:
  /** Gives the place where a row meets the triangle's plane, within the triangle's extent; the row must meet it. */
  static double
  PlaceOnRow(const Point & a, const Point & b, const Point & c, double y, double z)
  {
    const double normal[3] = { (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                               (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
                               (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) };
    const double x = a[0] - (normal[1] * (y - a[1]) + normal[2] * (z - a[2])) / normal[0];
    const auto [least, most] = std::minmax({ a[0], b[0], c[0] });
    return x >= least ? std::min(x, most) : least; // Rounding can have made the divisor 0, too.
  }

  const std::array<std::int32_t, 3>            m_Size;
  std::vector<std::pair<std::int64_t, double>> m_Crossings;
};

std::vector<std::int64_t>
CountVoxelsOfImage(VertexId numberOfVertices, const LabelVolume & labels)
{
  std::vector<std::int64_t> counts(static_cast<std::size_t>(numberOfVertices), 0);
  for (const VertexId v : labels.vertices)
  {
    ++counts[v];
  }
  return counts;
}

std::vector<std::vector<std::size_t>>
TrianglesOfCells(const WallMesh & walls, VertexId numberOfVertices)
{
  std::vector<std::vector<std::size_t>> triangles(static_cast<std::size_t>(numberOfVertices));
  for (std::size_t t = 0; t < walls.triangles.size(); ++t)
  {
    for (const VertexId v : walls.walls[walls.wallOfTriangle[t]].cells)
    {
      if (v != ExteriorVertex && v < numberOfVertices)
      {
        triangles[v].push_back(t);
      }
    }
  }
  return triangles;
}
} // namespace

std::vector<double>
ComputeVoxelDice(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                 const Execution & execution)
{
  // Each cell by itself: its triangles cross rows of voxels, the voxels between two crossings are those in the mesh,
  // and those of them that the image gives to the cell are common to both.
  std::vector<Point> indices(walls.points.size());
  std::transform(walls.points.begin(), walls.points.end(), indices.begin(), [&labels](const Point & p) {
    return labels.ToIndex(p);
  });
  const auto                      trianglesOfCell = TrianglesOfCells(walls, numberOfVertices);
  const std::vector<std::int64_t> inImage = CountVoxelsOfImage(numberOfVertices, labels);
  std::vector<double>             dice(static_cast<std::size_t>(numberOfVertices), 0.0);
  execution.For(dice.size(), [&](std::size_t cell) {
    RowCrossings crossings(labels.size);
    for (const std::size_t t : trianglesOfCell[cell])
    {
      const auto & triangle = walls.triangles[t];
      crossings.AddTriangle(indices[triangle[0]], indices[triangle[1]], indices[triangle[2]]);
    }
    std::int64_t inMesh = 0;
    std::int64_t common = 0;
    crossings.VisitWithin([&](std::int64_t row, const Range & range) {
      if (range.first <= range.last)
      {
        inMesh += range.last - range.first + 1;
        common += labels.vertices.Visit([&](const auto * first) {
          const auto * const begin = first + row * labels.size[0];
          return std::count(begin + range.first, begin + range.last + 1, static_cast<VertexId>(cell));
        });
      }
    });
    dice[cell] = common > 0 ? 2.0 * static_cast<double>(common) / static_cast<double>(inMesh + inImage[cell]) : 0.0;
  });
  return dice;
}
} // namespace tissue
