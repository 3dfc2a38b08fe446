/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueStatistics_h
#define TissueTessellationCore_TissueStatistics_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace tissue
{
struct LabelVolume;

/** What a statistic is that cannot be measured. */
constexpr double UnknownStatistic = std::numeric_limits<double>::quiet_NaN();

/** The curvatures of a surface at a place, per unit of length, seen along its normal: those of a ball are positive. */
struct Curvatures
{
  double maximum = UnknownStatistic;
  double minimum = UnknownStatistic;

  double
  Mean() const
  {
    return 0.5 * (maximum + minimum);
  }

  double
  Gaussian() const
  {
    return maximum * minimum;
  }
};

/** \brief The shape of a cell and its place in the tissue. What cannot be measured is UnknownStatistic. */
struct CellStatistics
{
  /** The area of its walls to the exterior, voids included. */
  double exteriorArea = 0.0;
  /** The part of that where the tissue is cut, see WallStatistics::cutArea. */
  double cutArea = 0.0;
  /** The surface of a ball of its volume over its own: 1 for a ball, less for all others (H. Wadell, Volume, Shape, and
   * Roundness of Quartz Particles, J. Geol. 43, 1935). */
  double sphericity = UnknownStatistic;
  /** 1 for the epidermis, 2 for its neighbours, and so on; 0 where no wall leads to the epidermis. */
  std::int32_t layer = 0;
  /** The axes of the ellipsoid that has the cell's moments of volume up to the second: lengths, longest first, and
   * directions of length 1 whose largest component is positive. */
  std::array<double, 3> axisLengths = { { UnknownStatistic, UnknownStatistic, UnknownStatistic } };
  std::array<Point, 3>  axes = { { { { UnknownStatistic, UnknownStatistic, UnknownStatistic } },
                                   { { UnknownStatistic, UnknownStatistic, UnknownStatistic } },
                                   { { UnknownStatistic, UnknownStatistic, UnknownStatistic } } } };
  /** Of the tissue's surface at a cell of the epidermis: by how the mean normals of its wall there and of those next to
   * it turn, so that the bulges of the cells do not count. */
  Curvatures curvatures;

  /** The longest axis over the middle one, and that over the shortest, as itk::ShapeLabelObject has them. */
  double
  Elongation() const
  {
    return axisLengths[0] / axisLengths[1];
  }

  double
  Flatness() const
  {
    return axisLengths[1] / axisLengths[2];
  }
};

/** \brief The shape of a wall. Its normal points from the first cell to the second. */
struct WallStatistics
{
  double area = 0.0;
  /** Weighted by the area. */
  Point center = { { UnknownStatistic, UnknownStatistic, UnknownStatistic } };
  /** The mean of the triangles' normals, of length 1. */
  Point normal = { { UnknownStatistic, UnknownStatistic, UnknownStatistic } };
  /** The area that the wall has, seen along its normal, over its area: 1 where it is flat. */
  double planarity = UnknownStatistic;
  /** The root mean square distance to the plane that fits best. */
  double planeDistance = UnknownStatistic;
  /** Of a quadratic surface through it; positive where it bulges into the second cell. */
  double meanCurvature = UnknownStatistic;
  /** Of a wall to the exterior, the area where the tissue is not at its end but cut, see MeasureTissue(). */
  double cutArea = 0.0;
};

/** \brief The statistics of a tissue's cells, by vertex (that of the exterior is empty), and of its walls. */
struct TissueStatistics
{
  std::vector<CellStatistics> cells;
  std::vector<WallStatistics> walls;
};

/** Measures the walls alone, of a mesh that RequireConsistentIndices() lets pass; their cutArea stays 0. */
std::vector<WallStatistics>
MeasureWalls(const WallMesh & mesh);

/** \brief Measures cells and walls.
 *
 * The tissue is cut, and its surface no epidermis,
 * - on the border of the image: where all points of a triangle of a cell that touches the border (Cell::touchesBorder)
 * lie within 1.5 voxels of its planes, and the triangle is within 60 degrees parallel to one of these;
 * - at planes within the image, as a mask leaves them: where 8 walls or more lie in one plane within a hundredth of the
 *   cells' diameter (that of a ball of their surface) or 0.4 voxels, as the bulging cells of an epidermis never do;
 * this does not count where such planes are not parallel or more than half of the surface, as those of a block or a
 * flat sheet;
 * - where whole cells are missing: where the surface is as rough as the inner walls are. A wall and those around it are
 *   then a tenth of the cells' diameter off a quadratic surface (root mean square; the median over a wall and those
 *   around it); this does not count where less than a fifth would be left.
 *
 * Of walls that are rough or in a plane those count that are surrounded by such, where they make up a tenth or more, in
 * a plane a twentieth or more, of the surface that is not on the border; with what is smaller between rough ones. So an
 * edge, and a crease between two organs, is no cut.
 *
 * What is left is cut as well where it is less than a fiftieth of the surface.
 *
 * The epidermis are the cells that have a fiftieth of their surface or more at the exterior that is neither cut nor a
 * void that the tissue encloses.
 *
 * \param grid that of the image, which may be empty: then nothing is known of its border.
 * \throws std::invalid_argument as RequireConsistentIndices does. */
TissueStatistics
MeasureTissue(const WallMesh & mesh, const std::vector<Cell> & cells, const ImageGrid & grid);

/** \throws std::invalid_argument where the statistics are not of as many vertices and walls as the mesh has. */
void
RequireStatisticsOf(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics);

/** Two cells that share walls. */
struct NeighborPair
{
  double       area = 0.0;
  std::int32_t numberOfWalls = 0;
};

/** The pairs of cells, without the exterior, that share walls, the vertices of each ascending. \param walls of the
 * mesh. */
std::map<VertexPair, NeighborPair>
FindNeighborPairs(const WallMesh & mesh, const std::vector<WallStatistics> & walls);

/** \brief A column of a table of cells or walls, for the files, arrays and languages that have such tables. */
struct StatisticColumn
{
  /** Flags, 0 or 1; counts; labels; and measures, which are UnknownStatistic where they are not known. */
  using Values =
    std::variant<std::vector<std::uint8_t>, std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<double>>;

  std::string name;
  /** 1, or 3 of a vector: x, y and z. */
  int numberOfComponents = 1;
  /** Row by row. */
  Values values;
};

/** All that is known of the cells: as the image has them, as the mesh has them, and their statistics. Rows are
 * vertices, and that of the exterior means nothing. `Label` is the first column. \param check the result of
 * CheckCellSurfaces. \param statistics that of MeasureTissue. \throws std::invalid_argument where these are for other
 * numbers, or as RequireConsistentIndices does. */
std::vector<StatisticColumn>
MakeCellColumns(const WallMesh & mesh, const std::vector<Cell> & cells, const CellSurfaceCheck & check,
                const TissueStatistics & statistics);

/** The same of the walls: `WallId`, `Label0` and `Label1` of the two cells, and WallStatistics. Rows are walls. */
std::vector<StatisticColumn>
MakeWallColumns(const WallMesh & mesh, const std::vector<Cell> & cells, const TissueStatistics & statistics);

/** \brief What an image of intensities has in a cell. Voxels whose value is not finite are not known, and left out. */
struct CellSignal
{
  /** Of the cell's voxels that are known. */
  double mean = UnknownStatistic;
  /** The sum of their values, times the volume of a voxel. */
  double integral = UnknownStatistic;
  /** Of those of them whose centres are at most at the distance asked for from the cell's walls. */
  double meanNearWalls = UnknownStatistic;
  /** Of the voxels that are known, in cubed physical units. */
  double knownVolume = 0.0;
};

/** \brief Measures an image of intensities in the cells, by vertex; that of the exterior is empty.
 *
 * \param labels say which cell the centre of a voxel is in; the image may have another grid than theirs.
 * \param grid of the image, whose steps must span a volume. \param values of its voxels, the first axis fastest.
 * \param mesh has the walls of the cells. \param wallDistance at least 0.
 * The result does not depend on `execution`.
 * \throws std::invalid_argument for a grid without volume, a negative distance, or as RequireConsistentIndices does. */
std::vector<CellSignal>
MeasureSignal(const LabelVolume & labels, const ImageGrid & grid, const float * values, const WallMesh & mesh,
              VertexId numberOfVertices, double wallDistance, const Execution & execution = Execution());

/** \brief The mean of a field of values over each wall, by area; UnknownStatistic where none of it is known.
 *
 * Each triangle is cut into equal ones, of edges no longer than `step` or than a 32nd of its own, and the field is
 * taken at their centres. \param valueAt is called from any thread; what is not finite is left out. */
std::vector<double>
MeasureOnWalls(const WallMesh & mesh, double step, const std::function<double(const Point &)> & valueAt,
               const Execution & execution = Execution());
} // namespace tissue

#endif
