/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Geometry/NearestInTriangle.h"
#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tissue
{
namespace
{
/** The image is summed up in as many slabs, whatever does them, so that the sums are the same for any threads. */
constexpr std::int32_t MostSlabs = 32;
constexpr int          MostCutsOfEdge = 32;

/** The sums of a cell's voxels. */
struct SignalSums
{
  double       all = 0.0;
  double       nearWalls = 0.0;
  std::int64_t numberOfAll = 0;
  std::int64_t numberNearWalls = 0;

  void
  Add(const SignalSums & more)
  {
    all += more.all;
    nearWalls += more.nearWalls;
    numberOfAll += more.numberOfAll;
    numberNearWalls += more.numberNearWalls;
  }
};

using Vectors = std::array<Point, 3>;

double
VolumeOf(const Vectors & steps)
{
  return Dot(steps[0], Cross(steps[1], steps[2]));
}

/** The products with these of a way in space are its steps along the axes. */
Vectors
ReciprocalsOf(const Vectors & steps)
{
  Vectors reciprocals{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    reciprocals[axis] = (1.0 / VolumeOf(steps)) * Cross(steps[(axis + 1) % 3], steps[(axis + 2) % 3]);
  }
  return reciprocals;
}

/** Where the voxels of an image are, and what is in them. */
struct Field
{
  Field(const LabelVolume & labelsOfCells, const ImageGrid & imageGrid, const float * valuesOfVoxels)
    : labels(labelsOfCells)
    , grid(imageGrid)
    , values(valuesOfVoxels)
    , voxelVolume(std::abs(VolumeOf(grid.steps)))
    , toIndex(ReciprocalsOf(grid.steps))
    , toIndexOfLabels(ReciprocalsOf(labels.steps))
  {
    if (!(voxelVolume > 0.0))
    {
      throw std::invalid_argument("MeasureSignal: the steps of the grid span no volume");
    }
  }

  Point
  PositionOf(std::int32_t x, std::int32_t y, std::int32_t z) const
  {
    return grid.origin + static_cast<double>(x) * grid.steps[0] + static_cast<double>(y) * grid.steps[1] +
           static_cast<double>(z) * grid.steps[2];
  }

  VertexId
  VertexAt(const Point & position) const
  {
    const Point way = position - labels.origin;
    const auto  index = [&](std::size_t axis) {
      return static_cast<std::int32_t>(std::floor(std::clamp(Dot(toIndexOfLabels[axis], way), -1e9, 1e9) + 0.5));
    };
    return labels.At(index(0), index(1), index(2));
  }

  std::size_t
  PlaneSize() const
  {
    return static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  }

  const LabelVolume & labels;
  const ImageGrid &   grid;
  const float *       values;
  double              voxelVolume;
  Vectors             toIndex;
  Vectors             toIndexOfLabels;
};

/** Some planes of the image, one after the other. */
class Slab
{
public:
  Slab(const Field & field, std::int32_t begin, std::int32_t end)
    : m_Field(field)
    , m_Begin(begin)
    , m_End(end)
    , m_Vertices(field.PlaneSize() * static_cast<std::size_t>(end - begin))
    , m_IsNearWall(m_Vertices.size(), 0)
  {
    std::size_t i = 0;
    for (std::int32_t z = begin; z < end; ++z)
    {
      for (std::int32_t y = 0; y < field.grid.size[1]; ++y)
      {
        for (std::int32_t x = 0; x < field.grid.size[0]; ++x)
        {
          m_Vertices[i++] = field.VertexAt(field.PositionOf(x, y, z));
        }
      }
    }
  }

  /** Marks the voxels of the cells of a wall near one of its triangles. */
  void
  MarkNear(const Point & a, const Point & b, const Point & c, const VertexPair & cells, double distance)
  {
    std::array<std::int32_t, 3> low;
    std::array<std::int32_t, 3> high;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Point & toIndex = m_Field.toIndex[axis];
      const auto [least, most] = std::minmax({ Dot(toIndex, a - m_Field.grid.origin),
                                               Dot(toIndex, b - m_Field.grid.origin),
                                               Dot(toIndex, c - m_Field.grid.origin) });
      const double margin = Norm(toIndex) * distance;
      const double first = axis == 2 ? m_Begin : 0;
      const double last = axis == 2 ? m_End - 1 : m_Field.grid.size[axis] - 1;
      low[axis] = static_cast<std::int32_t>(std::ceil(std::clamp(least - margin, first, last + 1.0)));
      high[axis] = static_cast<std::int32_t>(std::floor(std::clamp(most + margin, first - 1.0, last)));
    }
    const Point normal = Normalized(Cross(b - a, c - a));
    for (std::int32_t z = low[2]; z <= high[2]; ++z)
    {
      for (std::int32_t y = low[1]; y <= high[1]; ++y)
      {
        for (std::int32_t x = low[0]; x <= high[0]; ++x)
        {
          const std::size_t i =
            (static_cast<std::size_t>(z - m_Begin) * m_Field.grid.size[1] + y) * m_Field.grid.size[0] + x;
          if (m_IsNearWall[i] || (m_Vertices[i] != cells[0] && m_Vertices[i] != cells[1]))
          {
            continue;
          }
          const Point position = m_Field.PositionOf(x, y, z);
          m_IsNearWall[i] = std::abs(Dot(normal, position - a)) <= distance &&
                            Distance(position, Combine(NearestInTriangle(position, a, b, c), a, b, c)) <= distance;
        }
      }
    }
  }

  void
  AddTo(std::vector<SignalSums> & sums) const
  {
    const float * const values = m_Field.values + m_Field.PlaneSize() * static_cast<std::size_t>(m_Begin);
    for (std::size_t i = 0; i < m_Vertices.size(); ++i)
    {
      // Voids have vertices beyond those of the cells.
      const auto vertex = static_cast<std::size_t>(m_Vertices[i]);
      if (vertex == ExteriorVertex || vertex >= sums.size() || !std::isfinite(values[i]))
      {
        continue;
      }
      SignalSums & sum = sums[vertex];
      sum.all += values[i];
      ++sum.numberOfAll;
      sum.nearWalls += m_IsNearWall[i] ? values[i] : 0.0f;
      sum.numberNearWalls += m_IsNearWall[i];
    }
  }

private:
  const Field &             m_Field;
  std::int32_t              m_Begin;
  std::int32_t              m_End;
  std::vector<VertexId>     m_Vertices;
  std::vector<std::uint8_t> m_IsNearWall;
};

CellSignal
ToSignal(const SignalSums & sums, double voxelVolume)
{
  CellSignal signal;
  if (sums.numberOfAll > 0)
  {
    signal.mean = sums.all / static_cast<double>(sums.numberOfAll);
    signal.integral = sums.all * voxelVolume;
    signal.knownVolume = static_cast<double>(sums.numberOfAll) * voxelVolume;
  }
  if (sums.numberNearWalls > 0)
  {
    signal.meanNearWalls = sums.nearWalls / static_cast<double>(sums.numberNearWalls);
  }
  return signal;
}

/** Adds the values at the centres of the triangles that a triangle is cut into, and how many they are. */
void
AddSamples(const std::array<Point, 3> & corners, double step, const std::function<double(const Point &)> & valueAt,
           double & sum, std::int64_t & count)
{
  const auto & [a, b, c] = corners;
  const double longest = std::max({ Distance(a, b), Distance(b, c), Distance(c, a) });
  const int    cuts = static_cast<int>(std::clamp(std::ceil(longest / step), 1.0, double{ MostCutsOfEdge }));
  for (int i = 0; i < cuts; ++i)
  {
    for (int j = 0; j < cuts - i; ++j)
    {
      // Of the two triangles of a parallelogram the second one is beyond the triangle in its last ones.
      for (int k = 0; k < (j + 1 < cuts - i ? 2 : 1); ++k)
      {
        const double u = (i + (k + 1) / 3.0) / cuts;
        const double v = (j + (k + 1) / 3.0) / cuts;
        const double value = valueAt((1.0 - u - v) * a + u * b + v * c);
        sum += std::isfinite(value) ? value : 0.0;
        count += std::isfinite(value) ? 1 : 0;
      }
    }
  }
}
} // namespace

std::vector<CellSignal>
MeasureSignal(const LabelVolume & labels, const ImageGrid & grid, const float * values, const WallMesh & mesh,
              VertexId numberOfVertices, double wallDistance, const Execution & execution)
{
  RequireConsistentIndices(mesh, numberOfVertices);
  if (!(wallDistance >= 0.0))
  {
    throw std::invalid_argument("MeasureSignal: the distance from the walls is " + std::to_string(wallDistance) +
                                ", must be 0 or more");
  }
  const Field                          field(labels, grid, values);
  const std::int32_t                   numberOfSlabs = std::min(grid.size[2], MostSlabs);
  std::vector<std::vector<SignalSums>> sumsOfSlab(static_cast<std::size_t>(numberOfSlabs));
  execution.For(sumsOfSlab.size(), [&](std::size_t s) {
    const auto begin = static_cast<std::int64_t>(s) * grid.size[2] / numberOfSlabs;
    const auto end = static_cast<std::int64_t>(s + 1) * grid.size[2] / numberOfSlabs;
    Slab       slab(field, static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto & [a, b, c] = mesh.triangles[t];
      const VertexPair & cells = mesh.walls[mesh.wallOfTriangle[t]].cells;
      slab.MarkNear(mesh.points[a], mesh.points[b], mesh.points[c], cells, wallDistance);
    }
    sumsOfSlab[s].resize(static_cast<std::size_t>(numberOfVertices));
    slab.AddTo(sumsOfSlab[s]);
  });
  std::vector<CellSignal> signals;
  for (std::size_t v = 0; v < static_cast<std::size_t>(numberOfVertices); ++v)
  {
    SignalSums sums;
    for (const std::vector<SignalSums> & ofSlab : sumsOfSlab)
    {
      sums.Add(ofSlab[v]);
    }
    signals.push_back(ToSignal(sums, field.voxelVolume));
  }
  return signals;
}

std::vector<double>
MeasureOnWalls(const WallMesh & mesh, double step, const std::function<double(const Point &)> & valueAt,
               const Execution & execution)
{
  const CompressedRows<std::size_t> trianglesOf(mesh.walls.size(), [&mesh](const auto & add) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      add(mesh.wallOfTriangle[t], t);
    }
  });
  std::vector<double>               means(mesh.walls.size(), UnknownStatistic);
  execution.For(means.size(), [&](std::size_t w) {
    double weighted = 0.0;
    double area = 0.0;
    for (const std::size_t t : trianglesOf[w])
    {
      const Triangle &           triangle = mesh.triangles[t];
      const std::array<Point, 3> corners{
        { mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]] }
      };
      double       sum = 0.0;
      std::int64_t count = 0;
      AddSamples(corners, step, valueAt, sum, count);
      if (count > 0)
      {
        const double ofTriangle = TriangleArea(corners[0], corners[1], corners[2]);
        weighted += ofTriangle * sum / static_cast<double>(count);
        area += ofTriangle;
      }
    }
    means[w] = area > 0.0 ? weighted / area : UnknownStatistic;
  });
  return means;
}
} // namespace tissue
