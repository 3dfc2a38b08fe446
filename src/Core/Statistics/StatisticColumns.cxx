/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include <algorithm>
#include <stdexcept>

namespace tissue
{
namespace
{
/** Columns with the same number of rows. */
class ColumnList
{
public:
  explicit ColumnList(std::size_t numberOfRows)
    : m_NumberOfRows(numberOfRows)
  {}

  template <typename TNumber, typename TValueOf>
  void
  Add(const char * name, const TValueOf & valueOf)
  {
    std::vector<TNumber> values;
    for (std::size_t row = 0; row < m_NumberOfRows; ++row)
    {
      values.push_back(static_cast<TNumber>(valueOf(row)));
    }
    m_Columns.push_back({ name, 1, std::move(values) });
  }

  template <typename TVectorOf>
  void
  AddVectors(const char * name, const TVectorOf & vectorOf)
  {
    std::vector<double> values;
    for (std::size_t row = 0; row < m_NumberOfRows; ++row)
    {
      const Point & vector = vectorOf(row);
      values.insert(values.end(), vector.begin(), vector.end());
    }
    m_Columns.push_back({ name, 3, std::move(values) });
  }

  std::vector<StatisticColumn>
  Take()
  {
    return std::move(m_Columns);
  }

private:
  std::size_t                  m_NumberOfRows;
  std::vector<StatisticColumn> m_Columns;
};

using Flag = std::uint8_t;
using Count = std::int32_t;
using Large = std::int64_t;
using Measure = double;

/** Counts the cells, without the exterior, with which each vertex shares a wall. */
std::vector<std::int32_t>
CountNeighbors(const WallMesh & mesh, const TissueStatistics & statistics)
{
  std::vector<std::int32_t> counts(statistics.cells.size(), 0);
  for (const auto & pair : FindNeighborPairs(mesh, statistics.walls))
  {
    ++counts[pair.first[0]];
    ++counts[pair.first[1]];
  }
  return counts;
}

void
AddSurfaces(const CellSurfaceCheck & check, ColumnList & columns)
{
  const std::vector<CellSurface> & surfaces = check.cells;
  columns.Add<Count>("NumberOfTriangles", [&](std::size_t v) { return surfaces[v].numberOfTriangles; });
  columns.Add<Count>("EulerCharacteristic", [&](std::size_t v) { return surfaces[v].eulerCharacteristic; });
  columns.Add<Measure>("MinimumDihedralAngle", [&](std::size_t v) { return check.angles.minimumDihedralOfCell[v]; });
  columns.Add<Flag>("IsClosed", [&](std::size_t v) { return surfaces[v].IsClosed(); });
}

/** What the image has of the cells, beside centres and volumes. */
void
AddImageFacts(const std::vector<Cell> & cells, ColumnList & columns)
{
  columns.Add<Flag>("TouchesExterior", [&](std::size_t v) { return cells[v].touchesExterior; });
  columns.Add<Flag>("TouchesBorder", [&](std::size_t v) { return cells[v].touchesBorder; });
  columns.Add<Count>("NumberOfPieces", [&](std::size_t v) { return cells[v].numberOfPieces; });
  columns.Add<Large>("NumberOfVoxels", [&](std::size_t v) { return cells[v].numberOfVoxels; });
  columns.Add<Large>("NumberOfStrayVoxels", [&](std::size_t v) { return cells[v].numberOfStrayVoxels; });
}

/** What is measured of the cells' shapes and places. */
void
AddShapes(const std::vector<CellStatistics> & cells, ColumnList & columns)
{
  columns.Add<Measure>("ExteriorArea", [&](std::size_t v) { return cells[v].exteriorArea; });
  columns.Add<Measure>("CutArea", [&](std::size_t v) { return cells[v].cutArea; });
  columns.Add<Count>("Layer", [&](std::size_t v) { return cells[v].layer; });
  columns.Add<Measure>("Sphericity", [&](std::size_t v) { return cells[v].sphericity; });
  columns.Add<Measure>("Elongation", [&](std::size_t v) { return cells[v].Elongation(); });
  columns.Add<Measure>("Flatness", [&](std::size_t v) { return cells[v].Flatness(); });
  for (int axis = 0; axis < 3; ++axis)
  {
    const char * const lengths[] = { "MajorAxisLength", "MiddleAxisLength", "MinorAxisLength" };
    const char * const directions[] = { "MajorAxis", "MiddleAxis", "MinorAxis" };
    columns.Add<Measure>(lengths[axis], [&](std::size_t v) { return cells[v].axisLengths[axis]; });
    columns.AddVectors(directions[axis], [&](std::size_t v) -> const Point & { return cells[v].axes[axis]; });
  }
  columns.Add<Measure>("MeanCurvature", [&](std::size_t v) { return cells[v].curvatures.Mean(); });
  columns.Add<Measure>("GaussianCurvature", [&](std::size_t v) { return cells[v].curvatures.Gaussian(); });
  columns.Add<Measure>("MaximumCurvature", [&](std::size_t v) { return cells[v].curvatures.maximum; });
  columns.Add<Measure>("MinimumCurvature", [&](std::size_t v) { return cells[v].curvatures.minimum; });
}
} // namespace

void
RequireStatisticsOf(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics)
{
  if (statistics.cells.size() != cells.size() || statistics.walls.size() != mesh.walls.size())
  {
    throw std::invalid_argument("the statistics are for " + std::to_string(statistics.cells.size()) + " vertices and " +
                                std::to_string(statistics.walls.size()) + " walls, must be for " +
                                std::to_string(cells.size()) + " and " + std::to_string(mesh.walls.size()));
  }
}

std::map<VertexPair, NeighborPair>
FindNeighborPairs(const WallMesh & mesh, const std::vector<WallStatistics> & walls)
{
  std::map<VertexPair, NeighborPair> pairs;
  for (std::size_t w = 0; w < walls.size(); ++w)
  {
    VertexPair cells = mesh.walls[w].cells;
    std::sort(cells.begin(), cells.end());
    if (walls[w].area > 0.0 && cells[0] != ExteriorVertex)
    {
      NeighborPair & pair = pairs[cells];
      pair.area += walls[w].area;
      ++pair.numberOfWalls;
    }
  }
  return pairs;
}

std::vector<StatisticColumn>
MakeCellColumns(const WallMesh & mesh, const std::vector<Cell> & cells, const CellSurfaceCheck & check,
                const TissueStatistics & statistics)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  RequireStatisticsOf(mesh, cells, statistics);
  if (check.cells.size() != cells.size())
  {
    throw std::invalid_argument("the check of the cells' surfaces is for " + std::to_string(check.cells.size()) +
                                " vertices, must be for " + std::to_string(cells.size()));
  }
  ColumnList columns(cells.size());
  columns.Add<Large>("Label", [&](std::size_t v) { return cells[v].label; });
  for (int axis = 0; axis < 3; ++axis)
  {
    const char * const names[] = { "CenterX", "CenterY", "CenterZ" };
    columns.Add<Measure>(names[axis], [&](std::size_t v) { return cells[v].center[axis]; });
  }
  columns.Add<Measure>("Volume", [&](std::size_t v) { return check.cells[v].volume; });
  columns.Add<Measure>("ImageVolume", [&](std::size_t v) { return cells[v].volume; });
  columns.Add<Measure>("SurfaceArea", [&](std::size_t v) { return check.cells[v].area; });
  const std::vector<std::int32_t> neighbors = CountNeighbors(mesh, statistics);
  columns.Add<Count>("NumberOfNeighbors", [&](std::size_t v) { return neighbors[v]; });
  AddSurfaces(check, columns);
  AddImageFacts(cells, columns);
  AddShapes(statistics.cells, columns);
  return columns.Take();
}

std::vector<StatisticColumn>
MakeWallColumns(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics)
{
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  RequireStatisticsOf(mesh, cells, statistics);
  const std::vector<WallStatistics> & walls = statistics.walls;
  ColumnList                          columns(walls.size());
  columns.Add<Count>("WallId", [](std::size_t w) { return w; });
  columns.Add<Large>("Label0", [&](std::size_t w) { return cells[mesh.walls[w].cells[0]].label; });
  columns.Add<Large>("Label1", [&](std::size_t w) { return cells[mesh.walls[w].cells[1]].label; });
  columns.Add<Measure>("Area", [&](std::size_t w) { return walls[w].area; });
  columns.AddVectors("Center", [&](std::size_t w) -> const Point & { return walls[w].center; });
  columns.AddVectors("Normal", [&](std::size_t w) -> const Point & { return walls[w].normal; });
  columns.Add<Measure>("Planarity", [&](std::size_t w) { return walls[w].planarity; });
  columns.Add<Measure>("PlaneDistance", [&](std::size_t w) { return walls[w].planeDistance; });
  columns.Add<Measure>("MeanCurvature", [&](std::size_t w) { return walls[w].meanCurvature; });
  columns.Add<Measure>("CutArea", [&](std::size_t w) { return walls[w].cutArea; });
  return columns.Take();
}
} // namespace tissue
