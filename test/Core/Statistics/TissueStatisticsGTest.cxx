/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include "Balls.h"
#include "FourCubes.h"
#include "LatticeTissue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace
{
using namespace tissue;
using namespace tissue_test;

const double Pi = std::acos(-1.0);

/** The statistics of the only cell of a mesh. */
CellStatistics
MeasureCell(const WallMesh & mesh)
{
  return MeasureTissue(mesh, std::vector<Cell>(2), ImageGrid()).cells[1];
}

/** Half a ball of cells on the lower border of an image whose axes are turned: z of the image is -x of space. */
class DomeStatistics : public testing::Test
{
protected:
  static constexpr double Radius = 44.0;

  static void
  SetUpTestSuite()
  {
    const int   side = 2 * static_cast<int>(Radius) + 4;
    LabelVolume volume = EmptyVolume({ { side, side, side / 2 } });
    volume.origin = { { 100.0, 200.0, 300.0 } };
    volume.steps = { { { { 0, 0, 0.5 } }, { { 0, 0.5, 0 } }, { { -0.5, 0, 0 } } } };
    const Point middle{ { 0.5 * (side - 1), 0.5 * (side - 1), -0.5 } };
    m_Tissue =
      MakeLatticeTissue(volume, 8, [&](const Point & p, const Point &) { return Distance(p, middle) <= Radius; });
    m_Statistics = MeasureTissue(m_Tissue.mesh, m_Tissue.junctions.cells, m_Tissue.junctions.grid);
  }

  static LatticeTissue    m_Tissue;
  static TissueStatistics m_Statistics;
};

LatticeTissue    DomeStatistics::m_Tissue;
TissueStatistics DomeStatistics::m_Statistics;
} // namespace

TEST(TissueStatistics, AxesOfAnEllipsoidAreItsOwn)
{
  const double               s = std::sqrt(0.5);
  const std::array<Point, 3> axes{ { { { s, s, 0 } }, { { 0, 0, 1 } }, { { s, -s, 0 } } } };
  const CellStatistics       cell = MeasureCell(Ellipsoid({ { 4, 1, 2 } }, axes, { { 10, 20, 30 } }));
  EXPECT_NEAR(cell.axisLengths[0], 8.0, 0.04);
  EXPECT_NEAR(cell.axisLengths[1], 4.0, 0.02);
  EXPECT_NEAR(cell.axisLengths[2], 2.0, 0.01);
  EXPECT_NEAR(cell.Elongation(), 2.0, 0.001);
  EXPECT_NEAR(cell.Flatness(), 2.0, 0.001);
  EXPECT_LT(Distance(cell.axes[0], axes[0]), 1e-3);
  EXPECT_NEAR(std::abs(Dot(cell.axes[1], axes[2])), 1.0, 1e-6);
  EXPECT_LT(Distance(cell.axes[2], axes[1]), 1e-3);
}

TEST(TissueStatistics, AxesOfABoxAreAlongItsSides)
{
  const CellStatistics cell = MeasureCell(MakeVoxelWallMesh({ { 3, 6, 2 } }, std::vector<VertexId>(36, 1)));
  EXPECT_NEAR(cell.axisLengths[0], 6.0 * std::sqrt(5.0 / 3.0), 1e-9);
  EXPECT_NEAR(cell.axisLengths[1], 3.0 * std::sqrt(5.0 / 3.0), 1e-9);
  EXPECT_NEAR(cell.axisLengths[2], 2.0 * std::sqrt(5.0 / 3.0), 1e-9);
  EXPECT_LT(Distance(cell.axes[0], { { 0, 1, 0 } }), 1e-9);
  EXPECT_LT(Distance(cell.axes[1], { { 1, 0, 0 } }), 1e-9);
  EXPECT_LT(Distance(cell.axes[2], { { 0, 0, 1 } }), 1e-9);
  EXPECT_NEAR(cell.sphericity, std::cbrt(36.0 * Pi * 36.0 * 36.0) / 72.0, 1e-12);
  EXPECT_NEAR(cell.exteriorArea, 72.0, 1e-9);
  EXPECT_EQ(cell.cutArea, 0.0);
  EXPECT_EQ(cell.layer, 1);
}

TEST(TissueStatistics, SphericityOfABallIsOne)
{
  EXPECT_NEAR(MeasureCell(UnitBall(4)).sphericity, 1.0, 1e-3);
}

TEST(TissueStatistics, WallsHaveTheirShape)
{
  const FourCubes        tissue;
  const TissueStatistics statistics = MeasureTissue(tissue.mesh, tissue.cells, ImageGrid());
  ASSERT_EQ(statistics.walls.size(), 8u);
  for (std::size_t w = 0; w < 8; ++w)
  {
    const WallStatistics & wall = statistics.walls[w];
    const VertexPair &     cells = tissue.mesh.walls[w].cells;
    const Point &          a = tissue.cells[cells[0]].center;
    const Point &          b = tissue.cells[cells[1]].center;
    if (cells[1] == ExteriorVertex)
    {
      EXPECT_DOUBLE_EQ(wall.area, 4.0);
      EXPECT_NEAR(wall.planarity, std::sqrt(2.0) / 4.0, 1e-12);
      continue;
    }
    EXPECT_DOUBLE_EQ(wall.area, 1.0);
    EXPECT_LT(Distance(wall.center, 0.5 * (a + b)), 1e-12);
    EXPECT_LT(Distance(wall.normal, b - a), 1e-12);
    EXPECT_DOUBLE_EQ(wall.planarity, 1.0);
    EXPECT_NEAR(wall.planeDistance, 0.0, 1e-9);
    EXPECT_TRUE(std::isnan(wall.meanCurvature)); // of four points
    EXPECT_EQ(wall.cutArea, 0.0);
  }
}

TEST(TissueStatistics, AWallBulgesIntoItsSecondCell)
{
  // The upper half of a ball of radius 2.
  WallMesh mesh = UnitBall(4);
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(),
                                      mesh.triangles.end(),
                                      [&mesh](const Triangle & t) {
                                        const auto & points = mesh.points;
                                        return points[t[0]][2] + points[t[1]][2] + points[t[2]][2] < 2.0;
                                      }),
                       mesh.triangles.end());
  mesh.wallOfTriangle.resize(mesh.triangles.size());
  for (Point & p : mesh.points)
  {
    p = 2.0 * p;
  }
  mesh.walls[0].cells = { { 1, 2 } };
  const auto walls = MeasureTissue(mesh, std::vector<Cell>(3), ImageGrid()).walls;
  EXPECT_NEAR(walls[0].meanCurvature, 0.5, 0.005);
  EXPECT_LT(Distance(walls[0].normal, { { 0, 0, 1 } }), 1e-9);
  EXPECT_LT(walls[0].planarity, 0.95);
  EXPECT_GT(walls[0].planarity, 0.7);
}

TEST(TissueStatistics, WithoutTrianglesNothingIsKnown)
{
  WallMesh mesh;
  mesh.walls = { { { { 1, ExteriorVertex } } } };
  const TissueStatistics statistics = MeasureTissue(mesh, std::vector<Cell>(2), ImageGrid());
  EXPECT_TRUE(std::isnan(statistics.cells[1].sphericity));
  EXPECT_TRUE(std::isnan(statistics.cells[1].Elongation()));
  EXPECT_EQ(statistics.cells[1].layer, 0);
  EXPECT_TRUE(std::isnan(statistics.walls[0].planarity));
  EXPECT_EQ(statistics.walls[0].area, 0.0);
  mesh.walls[0].cells[0] = 2;
  EXPECT_THROW(MeasureTissue(mesh, std::vector<Cell>(2), ImageGrid()), std::invalid_argument);
}

TEST_F(DomeStatistics, CurvatureIsThatOfTheBall)
{
  const double expected = 1.0 / (0.5 * Radius); // the voxels' steps are half a unit
  double       sum = 0.0;
  int          count = 0;
  int          numberOff = 0;
  for (std::size_t v = 1; v < m_Statistics.cells.size(); ++v)
  {
    const CellStatistics & cell = m_Statistics.cells[v];
    EXPECT_TRUE(cell.layer == 1 || std::isnan(cell.curvatures.Mean()));
    if (cell.layer == 1 && cell.cutArea == 0.0)
    {
      sum += cell.curvatures.Mean();
      numberOff += std::abs(cell.curvatures.Mean() - expected) > 0.2 * expected ? 1 : 0;
      ++count;
    }
  }
  ASSERT_GT(count, 150);
  EXPECT_NEAR(sum / count, expected, 0.05 * expected);
  EXPECT_LT(numberOff, 0.1 * count);
}

TEST_F(DomeStatistics, TheUndersideAtTheBorderOfTheImageIsCutAndNoEpidermis)
{
  const std::vector<bool> isAtBackground = FindCellsAtBackground(m_Tissue.volume);
  double                  cutArea = 0.0;
  int                     wrong = 0;
  for (std::size_t v = 1; v < m_Statistics.cells.size(); ++v)
  {
    cutArea += m_Statistics.cells[v].cutArea;
    wrong += (m_Statistics.cells[v].layer == 1) == isAtBackground[v] ? 0 : 1;
  }
  // Cells that have hardly a voxel at the background are none of the epidermis.
  EXPECT_LT(wrong, 0.03 * m_Statistics.cells.size());
  EXPECT_NEAR(cutArea, Pi * std::pow(0.5 * Radius, 2), 0.05 * Pi * std::pow(0.5 * Radius, 2));
}

TEST_F(DomeStatistics, LayersCountFromTheEpidermis)
{
  const TissueStatistics & statistics = m_Statistics;
  std::vector<int>         least(statistics.cells.size(), 1 << 20);
  for (const WallMesh::Wall & wall : m_Tissue.mesh.walls)
  {
    for (int side = 0; side < 2; ++side)
    {
      if (wall.cells[1 - side] != ExteriorVertex)
      {
        least[wall.cells[side]] = std::min(least[wall.cells[side]], statistics.cells[wall.cells[1 - side]].layer);
      }
    }
  }
  int deepest = 0;
  for (std::size_t v = 1; v < statistics.cells.size(); ++v)
  {
    const int layer = statistics.cells[v].layer;
    EXPECT_TRUE(layer == 1 || layer == least[v] + 1) << layer;
    deepest = std::max(deepest, layer);
  }
  EXPECT_GE(deepest, 3);
}

TEST(TissueStatistics, AVoidHasNoEpidermis)
{
  // A cube of 5 voxels, its middle a void; the six voxels about the void are cells of their own.
  std::vector<VertexId> vertices(125, 1);
  const int             middle = 62;
  VertexId              last = 1;
  for (const int step : { -25, -5, -1, 1, 5, 25 })
  {
    vertices[middle + step] = ++last;
  }
  vertices[middle] = ExteriorVertex;
  const WallMesh mesh = MakeVoxelWallMesh({ { 5, 5, 5 } }, vertices);
  const auto     cells = MeasureTissue(mesh, std::vector<Cell>(8), ImageGrid()).cells;
  EXPECT_EQ(cells[1].layer, 1);
  for (int v = 2; v < 8; ++v)
  {
    EXPECT_EQ(cells[v].layer, 2);
    EXPECT_DOUBLE_EQ(cells[v].exteriorArea, 1.0);
    EXPECT_TRUE(std::isnan(cells[v].curvatures.Mean()));
  }
}

TEST(TissueStatistics, ATissueThatFillsTheImageHasNoEpidermis)
{
  // But for a voxel at a corner, a hundredth of the surface.
  const int             side = 6;
  std::vector<VertexId> vertices;
  for (int i = 0; i < side * side * side; ++i)
  {
    vertices.push_back(i == 0 ? ExteriorVertex : i % side < 3 ? 1 : 2);
  }
  const WallMesh    mesh = MakeVoxelWallMesh({ { side, side, side } }, vertices);
  std::vector<Cell> cells(3);
  for (Cell & cell : cells)
  {
    cell.touchesBorder = true;
  }
  ImageGrid grid;
  grid.size = { { 10 * side, 10 * side, 10 * side } };
  grid.steps = { { { { 0.1, 0, 0 } }, { { 0, 0.1, 0 } }, { { 0, 0, 0.1 } } } };
  grid.origin = { { 0.05, 0.05, 0.05 } };
  const auto statistics = MeasureTissue(mesh, cells, grid).cells;
  for (const VertexId cell : { 1, 2 })
  {
    EXPECT_EQ(statistics[cell].layer, 0);
    EXPECT_NEAR(statistics[cell].exteriorArea, 108.0, 1e-9);
    EXPECT_NEAR(statistics[cell].cutArea, 108.0, 1e-9);
    EXPECT_TRUE(std::isnan(statistics[cell].curvatures.Mean()));
  }
}
