/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Points/TissueMask.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>

namespace tissue
{
namespace
{
/** A tetrahedron of cells, or a surface triangle with the depths of its corners, and the box of what it fills. */
struct Solid
{
  std::array<Point, 4>  corners;
  std::array<double, 3> depths;
  bool                  isTriangle;
  Box                   box;
};

/** \brief A slice of the grid, some planes high, that one thread fills. */
class MaskSlab
{
public:
  MaskSlab(TissueMask & mask, std::int32_t first, std::int32_t end)
    : m_Mask(mask)
    , m_First(first)
    , m_End(end)
  {}

  /** Marks the grid points in a tetrahedron: those whose barycentric coordinates are all 0 or more. The gradients are
   * of three of these, which grow linearly from the first corner. */
  void
  AddTetrahedron(const Solid & solid)
  {
    const auto & c = solid.corners;
    const Point  sides[] = { c[1] - c[0], c[2] - c[0], c[3] - c[0] };
    const double volume = Dot(sides[0], Cross(sides[1], sides[2]));
    if (volume == 0.0)
    {
      return;
    }
    const Point gradients[] = { (1.0 / volume) * Cross(sides[1], sides[2]),
                                (1.0 / volume) * Cross(sides[2], sides[0]),
                                (1.0 / volume) * Cross(sides[0], sides[1]) };
    const Range x = this->RangeOf(0, solid.box);
    const Range y = this->RangeOf(1, solid.box);
    const Range z = this->RangeOf(2, solid.box);
    for (std::int32_t k = z.first; k <= z.last; ++k)
    {
      for (std::int32_t j = y.first; j <= y.last; ++j)
      {
        for (std::int32_t i = x.first; i <= x.last; ++i)
        {
          const Point  offset = m_Mask.grid.Position(i, j, k) - c[0];
          const double a = Dot(gradients[0], offset);
          const double b = Dot(gradients[1], offset);
          const double d = Dot(gradients[2], offset);
          if (a >= 0.0 && b >= 0.0 && d >= 0.0 && a + b + d <= 1.0)
          {
            m_Mask.inside[m_Mask.grid.Offset(i, j, k)] = 1;
          }
        }
      }
    }
  }

  /** Marks the grid points in balls along a triangle, whose radii are linear between the corners' depths. The balls are
   * a grid step apart, or a third of their radius, where the dents between them are a seventieth of the radius deep. */
  void
  AddTriangle(const Solid & solid)
  {
    const auto & c = solid.corners;
    const double step = std::max(std::min({ m_Mask.grid.steps[0], m_Mask.grid.steps[1], m_Mask.grid.steps[2] }),
                                 *std::min_element(solid.depths.begin(), solid.depths.end()) / 3.0);
    const double longest = std::max({ Distance(c[0], c[1]), Distance(c[1], c[2]), Distance(c[2], c[0]) });
    const int    n = std::max(1, static_cast<int>(std::ceil(longest / step)));
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; i + j <= n; ++j)
      {
        const double a = static_cast<double>(i) / n;
        const double b = static_cast<double>(j) / n;
        const double radius = (1.0 - a - b) * solid.depths[0] + a * solid.depths[1] + b * solid.depths[2];
        this->AddBall((1.0 - a - b) * c[0] + a * c[1] + b * c[2], radius);
      }
    }
  }

private:
  void
  AddBall(const Point & center, double radius)
  {
    const Range y = this->RangeOf(1, center[1], radius);
    const Range z = this->RangeOf(2, center[2], radius);
    for (std::int32_t k = z.first; k <= z.last; ++k)
    {
      for (std::int32_t j = y.first; j <= y.last; ++j)
      {
        const Point  offset = m_Mask.grid.Position(0, j, k) - center;
        const double rest = radius * radius - offset[1] * offset[1] - offset[2] * offset[2];
        if (rest >= 0.0)
        {
          const Range x = this->RangeOf(0, center[0], std::sqrt(rest));
          if (x.first <= x.last)
          {
            std::fill_n(m_Mask.inside.begin() + static_cast<std::ptrdiff_t>(m_Mask.grid.Offset(x.first, j, k)),
                        x.last - x.first + 1,
                        std::uint8_t{ 1 });
          }
        }
      }
    }
  }

  struct Range
  {
    std::int32_t first;
    std::int32_t last;
  };

  /** Gives the slab's grid points along an axis that are within a distance of a position; none where last < first. */
  Range
  RangeOf(int axis, double center, double distance) const
  {
    const double first = axis == 2 ? m_First : 0.0;
    const double last = (axis == 2 ? m_End : m_Mask.grid.size[axis]) - 1.0;
    const double middle = (center - m_Mask.grid.lower[axis]) / m_Mask.grid.steps[axis] - 0.5;
    const double reach = distance / m_Mask.grid.steps[axis];
    return { static_cast<std::int32_t>(std::clamp(std::ceil(middle - reach), first, last + 1.0)),
             static_cast<std::int32_t>(std::clamp(std::floor(middle + reach), first - 1.0, last)) };
  }

  Range
  RangeOf(int axis, const Box & box) const
  {
    return this->RangeOf(axis, 0.5 * (box.lower[axis] + box.upper[axis]), 0.5 * (box.upper[axis] - box.lower[axis]));
  }

  TissueMask & m_Mask;
  std::int32_t m_First;
  std::int32_t m_End;
};

/** Makes a solid of each tetrahedron, a surface triangle of one with the exterior. The boxes of triangles are wider by
 * the greatest depth of their corners. */
std::vector<Solid>
CollectSolids(const AdjacencyComplex & complex, const std::vector<Point> & centers, const std::vector<double> & depths)
{
  std::vector<Solid> solids;
  for (const VertexQuadruple & t : complex.GetTetrahedra())
  {
    Solid solid;
    solid.isTriangle = t[0] == ExteriorVertex;
    const int first = solid.isTriangle ? 1 : 0;
    solid.box = { centers[t[3]], centers[t[3]] };
    double depth = 0.0;
    for (int i = first; i < 4; ++i)
    {
      solid.corners[i - first] = centers[t[i]];
      Extend(solid.box, centers[t[i]]);
      if (solid.isTriangle)
      {
        solid.depths[i - 1] = depths[t[i]];
        depth = std::max(depth, depths[t[i]]);
      }
    }
    for (int i = 0; i < 3; ++i)
    {
      solid.box.lower[i] -= depth;
      solid.box.upper[i] += depth;
    }
    solids.push_back(solid);
  }
  return solids;
}

/** Makes tissue of all from where the sides of the box cannot be reached.
 *
 * A flood from the points at the sides, through the neighbours along the axes, marks what is outside; the rest is
 * tissue. */
void
FillVoids(TissueMask & mask)
{
  constexpr std::uint8_t   outside = 2; // The mask itself has 0 and 1 only.
  std::vector<std::size_t> open;
  const auto               visit = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    std::uint8_t & value = mask.inside[mask.grid.Offset(x, y, z)];
    if (value == 0)
    {
      value = outside;
      open.push_back(mask.grid.Offset(x, y, z));
    }
  };
  const auto & size = mask.grid.size;
  for (std::int32_t z = 0; z < size[2]; ++z)
  {
    for (std::int32_t y = 0; y < size[1]; ++y)
    {
      const bool isSide = z == 0 || y == 0 || z == size[2] - 1 || y == size[1] - 1;
      for (std::int32_t x = 0; x < size[0]; x += isSide ? 1 : std::max(1, size[0] - 1))
      {
        visit(x, y, z);
      }
    }
  }
  while (!open.empty())
  {
    const std::size_t at = open.back();
    open.pop_back();
    const auto x = static_cast<std::int32_t>(at % size[0]);
    const auto y = static_cast<std::int32_t>(at / size[0] % size[1]);
    const auto z = static_cast<std::int32_t>(at / size[0] / size[1]);
    for (const int s : { -1, 1 })
    {
      if (x + s >= 0 && x + s < size[0])
      {
        visit(x + s, y, z);
      }
      if (y + s >= 0 && y + s < size[1])
      {
        visit(x, y + s, z);
      }
      if (z + s >= 0 && z + s < size[2])
      {
        visit(x, y, z + s);
      }
    }
  }
  for (std::uint8_t & value : mask.inside)
  {
    value = value == outside ? 0 : 1;
  }
}
} // namespace

TissueMask
EstimateTissueMask(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                   const std::vector<double> & depths, const TissueGrid & grid, const Execution & execution)
{
  constexpr std::int32_t   planesAtATime = 4; // Thin slices share the work well, thick ones save looking at all solids.
  const std::vector<Solid> solids = CollectSolids(complex, centers, depths);
  TissueMask               mask{ grid, std::vector<std::uint8_t>(grid.NumberOfPoints(), 0) };
  execution.For((mask.grid.size[2] + planesAtATime - 1) / planesAtATime, [&](std::size_t part) {
    const auto   first = static_cast<std::int32_t>(part) * planesAtATime;
    const auto   end = std::min(first + planesAtATime, mask.grid.size[2]);
    const double lower = mask.grid.lower[2] + first * mask.grid.steps[2];
    const double upper = mask.grid.lower[2] + end * mask.grid.steps[2];
    MaskSlab     slab(mask, first, end);
    for (const Solid & solid : solids)
    {
      if (solid.box.lower[2] <= upper && solid.box.upper[2] >= lower)
      {
        solid.isTriangle ? slab.AddTriangle(solid) : slab.AddTetrahedron(solid);
      }
    }
  });
  FillVoids(mask);
  return mask;
}

TissueSamples
SampleMask(const TissueMask & mask)
{
  // The samples of each cube of 4 x 4 x 4 grid points make a group. Seeds are looked up once for the ball about it, so
  // that larger groups have more seeds to compare, and smaller ones more look-ups.
  constexpr std::int32_t brick = 4;
  TissueSamples          samples;
  samples.boxSize = mask.grid.steps;
  const double radius = 0.5 * (brick - 1) * Norm(mask.grid.steps);
  for (std::int32_t z0 = 0; z0 < mask.grid.size[2]; z0 += brick)
  {
    for (std::int32_t y0 = 0; y0 < mask.grid.size[1]; y0 += brick)
    {
      for (std::int32_t x0 = 0; x0 < mask.grid.size[0]; x0 += brick)
      {
        const std::size_t before = samples.points.size();
        for (std::int32_t z = z0; z < std::min(z0 + brick, mask.grid.size[2]); ++z)
        {
          for (std::int32_t y = y0; y < std::min(y0 + brick, mask.grid.size[1]); ++y)
          {
            for (std::int32_t x = x0; x < std::min(x0 + brick, mask.grid.size[0]); ++x)
            {
              if (mask.inside[mask.grid.Offset(x, y, z)] != 0)
              {
                samples.points.push_back(mask.grid.Position(x, y, z));
              }
            }
          }
        }
        if (samples.points.size() > before)
        {
          const Point center =
            0.5 * (mask.grid.Position(x0, y0, z0) + mask.grid.Position(x0 + brick - 1, y0 + brick - 1, z0 + brick - 1));
          samples.groups.push_back({ center, radius, samples.points.size() });
        }
      }
    }
  }
  return samples;
}
} // namespace tissue
