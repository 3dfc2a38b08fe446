/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CornerFitting.h"

#include "Dual/CellCorners.h"
#include "Dual/DualMesh.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>

namespace tissue
{
namespace
{
/** How far a corner may move from its junction, in voxels. The spline reaches two voxels along each axis, so that the
 * place of a corner much farther off cannot be told from the junction. */
constexpr double Reach = 3.0;
/** The least length of a triple line along its direction in the image, in voxels. It keeps corners apart that coincide
 * or are in the wrong order, from which most crossings of the unfitted star come. */
constexpr double LeastLength = 1.0;
/** How often the lines' directions are taken anew from the image, and the most sweeps between two of these times. With
 * so many no line pointed the wrong way any more in the tissue they were tried on; sweeps end when all are long enough.
 */
constexpr int NumberOfDirectionUpdates = 6;
constexpr int SweepsPerDirection = 40;
/** The share of what a line lacks that each of its ends moves in a sweep. 1/2 would mend a line by itself at once; less
 * converges where a corner is at the end of several short lines. */
constexpr double Relaxation = 0.4;

/** A triple line from one corner to another. Its cells come counterclockwise seen from the second. */
struct CornerPair
{
  PointId      from;
  PointId      to;
  VertexTriple cells;
  Point        direction;
};

/** Finds the cell that two neighbouring corners have in common besides those of the wall; -1 if there is none. */
VertexId
ThirdCell(const VertexQuadruple & a, const VertexQuadruple & b, const VertexPair & wall)
{
  for (const VertexId v : a)
  {
    if (v != wall[0] && v != wall[1] && std::find(b.begin(), b.end(), v) != b.end())
    {
      return v;
    }
  }
  return -1;
}

std::vector<CornerPair>
CollectLines(const DualMesh & dual, const std::vector<VertexQuadruple> & tetrahedra)
{
  std::vector<CornerPair> lines;
  for (const DualMesh::Wall & wall : dual.walls)
  {
    for (std::size_t i = 0; i < wall.corners.size(); ++i)
    {
      const PointId  a = wall.corners[i];
      const PointId  b = wall.corners[(i + 1) % wall.corners.size()];
      const VertexId third = ThirdCell(tetrahedra[a], tetrahedra[b], wall.cells);
      // A line is met in each of its three walls, and taken from one of them.
      if (third > wall.cells[0] && third > wall.cells[1])
      {
        lines.push_back({ a, b, { { wall.cells[0], wall.cells[1], third } }, {} });
      }
    }
  }
  return lines;
}

/** Moves corners apart until every line is at least LeastLength long along its direction in the image.
 *
 * A line's direction is the tangent of its triple line in the image at its middle, one voxel long, so that the dot
 * product with it, over its square, is a length in voxels. In a sweep the moves of all lines are summed up before any
 * corner moves, which makes the result independent of the lines' order up to rounding. */
void
KeepApart(std::vector<CornerPair> & lines, const IndicatorField & field, std::vector<Point> & corners)
{
  std::vector<Point> moves(corners.size());
  for (int update = 0; update < NumberOfDirectionUpdates; ++update)
  {
    for (CornerPair & line : lines)
    {
      const Point direction =
        Normalized(field.LineDirection(0.5 * (corners[line.from] + corners[line.to]), line.cells));
      const double voxels = field.LengthInVoxels(direction);
      line.direction = voxels > 0.0 ? (1.0 / voxels) * direction : direction;
    }
    for (int sweep = 0; sweep < SweepsPerDirection; ++sweep)
    {
      std::fill(moves.begin(), moves.end(), Point{ { 0.0, 0.0, 0.0 } });
      bool isMoved = false;
      for (const CornerPair & line : lines)
      {
        const double squared = Dot(line.direction, line.direction);
        if (!(squared > 0.0))
        {
          continue;
        }
        const double missing = LeastLength - Dot(corners[line.to] - corners[line.from], line.direction) / squared;
        if (missing > 1e-3)
        {
          moves[line.from] = moves[line.from] - Relaxation * missing * line.direction;
          moves[line.to] = moves[line.to] + Relaxation * missing * line.direction;
          isMoved = true;
        }
      }
      if (!isMoved)
      {
        break;
      }
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        corners[i] = corners[i] + moves[i];
      }
    }
  }
}
} // namespace

std::vector<Point>
FitCorners(const AdjacencyComplex & complex, const JunctionSet & junctions, const IndicatorField & field,
           std::vector<std::size_t> * unfitted)
{
  const std::vector<VertexQuadruple> tetrahedra = complex.GetTetrahedra();
  std::vector<Point>                 corners = ComputeCorners(complex, junctions, CornerRule::ImageJunction);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const bool isFitted =
      FindJunction(junctions, tetrahedra[i]) != nullptr && field.Project(corners[i], tetrahedra[i], 4, Reach);
    if (!isFitted && unfitted != nullptr)
    {
      unfitted->push_back(i);
    }
  }
  std::vector<CornerPair> lines = CollectLines(Dualize(complex, corners), tetrahedra);
  KeepApart(lines, field, corners);
  return corners;
}
} // namespace tissue
