/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/ImageDual.h"

#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace tissue
{
namespace
{
/** Sweeps in which corners without a place go to the mean of their neighbours: a few such corners in a row are all that
 * moves leave. */
constexpr int AveragingSweeps = 50;
/** The share of the way to the centres of its cells by which a line without a path is off the middle of its ends: two
 * such lines with the same ends must not be one. */
constexpr double ShareOfLine = 0.02;
/** The length of a line of the exterior, over the distance of its ends, from which on it is bent: cells bulge there,
 * and the walls that end at it with it. Within the tissue more points at the lines gain nothing. */
constexpr double LeastBend = 1.15;
/** The share of the way to the mean of its cells' centres that a corner goes where another is at its place. */
constexpr double ShareOfCorner = 0.05;

std::vector<TetrahedronId>
OrderByCells(const GeneralComplex & complex, const std::vector<VertexId> & cellOf)
{
  using Key = std::tuple<bool, VertexQuadruple, TetrahedronId>;
  std::vector<Key> keys;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      const VertexQuadruple cells = CellsOf(complex.GetTetrahedron(id).vertices, cellOf);
      keys.emplace_back(!AreDifferent(cells), Canonical(cells), id);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<TetrahedronId> order;
  for (const Key & key : keys)
  {
    order.push_back(std::get<TetrahedronId>(key));
  }
  return order;
}

/** The mean of the cells' centres, the exterior left out; the origin where all are the exterior's. */
template <std::size_t VLength>
Point
MeanCenter(const std::array<VertexId, VLength> & vertices, const std::vector<VertexId> & cellOf,
           const std::vector<Point> & centers)
{
  Point  sum{ { 0.0, 0.0, 0.0 } };
  double count = 0.0;
  for (const VertexId v : vertices)
  {
    if (cellOf[v] != ExteriorVertex)
    {
      sum = sum + centers[cellOf[v]];
      count += 1.0;
    }
  }
  return count > 0.0 ? (1.0 / count) * sum : sum;
}

void
AverageNeighbors(const GeneralComplex & complex, const std::vector<TetrahedronId> & ids, std::vector<Point> & corners)
{
  for (int sweep = 0; sweep < AveragingSweeps; ++sweep)
  {
    for (const TetrahedronId id : ids)
    {
      Point sum{ { 0.0, 0.0, 0.0 } };
      for (const TetrahedronId neighbor : complex.GetTetrahedron(id).neighbors)
      {
        sum = sum + corners[neighbor];
      }
      corners[id] = 0.25 * sum;
    }
  }
}

/** Moves the corner to the nearest place of its vertices; false where the image has none. */
bool
MoveToPlace(const std::vector<CornerPlace> & places, VertexQuadruple vertices, Point & corner)
{
  std::sort(vertices.begin(), vertices.end());
  const auto begin =
    std::lower_bound(places.begin(), places.end(), vertices, [](const CornerPlace & place, const VertexQuadruple & v) {
      return place.cells < v;
    });
  double      least = std::numeric_limits<double>::infinity();
  const Point from = corner;
  for (auto place = begin; place != places.end() && place->cells == vertices; ++place)
  {
    const double distance = Distance(place->position, from);
    if (distance < least)
    {
      least = distance;
      corner = place->position;
    }
  }
  return least < std::numeric_limits<double>::infinity();
}

void
SeparateCoincident(const DualMesh & mesh, const std::vector<VertexId> & cellOf, const std::vector<Point> & centers,
                   std::vector<Point> & corners)
{
  std::map<Point, int> counts;
  for (const Point & corner : corners)
  {
    ++counts[corner];
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (counts[mesh.corners[i]] > 1)
    {
      corners[i] = corners[i] + ShareOfCorner * (MeanCenter(mesh.cellsOfCorner[i], cellOf, centers) - corners[i]);
    }
  }
}

/** A line of the image where that has one; else a straight one, a little towards its own cells. */
LinePath
MakePath(const ImageNerve & nerve, const GeneralComplex & complex, const Side & side,
         const std::vector<Point> & corners, const std::vector<VertexId> & cellOf, const std::vector<Point> & centers)
{
  const GeneralComplex::Tetrahedron & t = complex.GetTetrahedron(side.tetrahedron);
  const VertexTriple                  vertices = TriangleOpposite(t.vertices, side.opposite);
  const Point &                       from = corners[side.tetrahedron];
  const Point &                       to = corners[t.neighbors[side.opposite]];
  const LineId                        line = t.lines[side.opposite];
  if (line == NoPlace)
  {
    const Point middle = 0.5 * (from + to);
    return { middle + ShareOfLine * (MeanCenter(vertices, cellOf, centers) - middle), false };
  }
  const bool isOutside =
    std::any_of(vertices.begin(), vertices.end(), [&](VertexId v) { return cellOf[v] == ExteriorVertex; });
  return { nerve.lines[line].middle, isOutside && nerve.lines[line].length > LeastBend * Distance(from, to) };
}
} // namespace

ImageDual
DualizeNerve(const ImageNerve & nerve, const std::vector<CornerPlace> & places, const std::vector<VertexId> & cellOf,
             const std::vector<Point> & centers)
{
  const GeneralComplex complex = nerve.complex.InOrder(OrderByCells(nerve.complex, cellOf));
  ImageDual            dual;
  std::vector<Point>   corners(complex.NumberOfTetrahedra());
  dual.isInImage.assign(corners.size(), true);
  std::vector<TetrahedronId> made;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    const GeneralComplex::Tetrahedron & t = complex.GetTetrahedron(id);
    corners[id] = t.corner != NoPlace ? nerve.corners[t.corner] : MeanCenter(t.vertices, cellOf, centers);
    if (t.corner == NoPlace)
    {
      made.push_back(id);
    }
  }
  AverageNeighbors(complex, made, corners);
  std::vector<TetrahedronId> missing;
  for (const TetrahedronId id : made)
  {
    dual.isInImage[id] = MoveToPlace(places, complex.GetTetrahedron(id).vertices, corners[id]);
    if (!dual.isInImage[id])
    {
      missing.push_back(id);
    }
  }
  AverageNeighbors(complex, missing, corners);
  dual.mesh = Dualize(
    complex, corners, [&](const Side & side) { return MakePath(nerve, complex, side, corners, cellOf, centers); });
  SeparateCoincident(dual.mesh, cellOf, centers, corners);
  dual.mesh.corners = std::move(corners);
  return dual;
}
} // namespace tissue
