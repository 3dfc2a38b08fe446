/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CornerFitting.h"

#include "Fitting/CellsAtPoint.h"
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

std::vector<CornerPair>
CollectLines(const DualMesh & dual, const std::vector<VertexId> & cellOf)
{
  std::vector<CornerPair> lines;
  for (const DualMesh::Line & line : dual.lines)
  {
    if (CellsOfVertices(line.cells, cellOf).count == 3)
    {
      const VertexTriple & v = line.cells;
      lines.push_back({ line.ends[0], line.ends[1], { { cellOf[v[0]], cellOf[v[1]], cellOf[v[2]] } }, {} });
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

std::vector<std::size_t>
FitCorners(ImageDual & dual, const std::vector<VertexId> & cellOf, const IndicatorField & field)
{
  std::vector<std::size_t> unfitted;
  for (std::size_t i = 0; i < dual.mesh.corners.size(); ++i)
  {
    const CellsAtPoint at = CellsOfVertices(dual.mesh.cellsOfCorner[i], cellOf);
    const bool         isFitted =
      at.count > 1 && dual.isInImage[i] && field.Project(dual.mesh.corners[i], at.cells, at.count, Reach);
    if (!isFitted && at.count == 4)
    {
      unfitted.push_back(i);
    }
  }
  std::vector<CornerPair> lines = CollectLines(dual.mesh, cellOf);
  KeepApart(lines, field, dual.mesh.corners);
  return unfitted;
}
} // namespace tissue
