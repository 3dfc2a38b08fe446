/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/WallProjection.h"

#include "TissueTessellationCore/Vector.h"

#include <algorithm>
#include <limits>

namespace tissue
{
namespace
{
/** The spline's support, beyond which the cells' indicators tell nothing. */
constexpr double      Reach = 3.0;
constexpr double      CornerShare = 0.5;
constexpr std::size_t Chunk = 512;

bool
HasLine(const JunctionSet & junctions, const VertexTriple & cells)
{
  const auto at = std::lower_bound(junctions.tripleLines.begin(),
                                   junctions.tripleLines.end(),
                                   cells,
                                   [](const TripleLine & line, const VertexTriple & key) { return line.cells < key; });
  return at != junctions.tripleLines.end() && at->cells == cells;
}

/** The image faces nearest to a point, of those of its wall. */
struct NearFaces
{
  Point        sum{ { 0.0, 0.0, 0.0 } };
  double       distance = 0.0;
  std::int64_t count = 0;
};
} // namespace

WallProjection::WallProjection(const WallMesh & mesh, const JunctionSet & junctions, const IndicatorField & field,
                               const ImageFaces & faces, const std::vector<double> & edgeLengths,
                               const std::vector<Point> & corners)
  : m_Field(field)
  , m_Faces(faces)
  , m_EdgeLengths(edgeLengths)
  , m_Corners(corners)
  , m_LineCells(mesh.points.size(), VertexTriple{ { -1, -1, -1 } })
  , m_Inner(mesh.walls.size())
{
  std::vector<unsigned char> isDone(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const WallId wall = mesh.wallOfTriangle[t];
    for (const PointId p : mesh.triangles[t])
    {
      if (mesh.numberOfCells[p] == CellsWithinWall && isDone[p] == 0)
      {
        isDone[p] = 1;
        m_Inner[wall].push_back(p);
      }
      else if (mesh.numberOfCells[p] == CellsOnLine)
      {
        VertexTriple & cells = m_LineCells[p];
        for (const VertexId v : mesh.walls[wall].cells)
        {
          if (std::find(cells.begin(), cells.end(), v) == cells.end())
          {
            *std::find(cells.begin(), cells.end(), -1) = v;
          }
        }
      }
    }
  }
  for (VertexTriple & cells : m_LineCells)
  {
    std::sort(cells.begin(), cells.end());
    if (cells[0] >= 0 && !HasLine(junctions, cells))
    {
      cells = { { -1, -1, -1 } };
    }
  }
  for (const WallMesh::Wall & wall : mesh.walls)
  {
    m_WallCells.push_back(wall.cells);
  }
}

void
WallProjection::Move(WallMesh & mesh, const ParallelFor & parallelFor) const
{
  const std::size_t numberOfPoints = mesh.points.size();
  RunFor(parallelFor, (numberOfPoints + Chunk - 1) / Chunk, [&](std::size_t c) {
    this->MoveLinesAndCorners(mesh, c * Chunk, std::min(numberOfPoints, (c + 1) * Chunk));
  });
  constexpr std::size_t wallsPerTask = 64;
  RunFor(parallelFor, (mesh.walls.size() + wallsPerTask - 1) / wallsPerTask, [&](std::size_t c) {
    for (std::size_t w = c * wallsPerTask; w < std::min(mesh.walls.size(), (c + 1) * wallsPerTask); ++w)
    {
      this->MoveWall(mesh, static_cast<WallId>(w));
    }
  });
}

void
WallProjection::MoveLinesAndCorners(WallMesh & mesh, std::size_t begin, std::size_t end) const
{
  for (std::size_t p = begin; p < end; ++p)
  {
    if (p < m_Corners.size())
    {
      mesh.points[p] = mesh.points[p] + CornerShare * (m_Corners[p] - mesh.points[p]);
    }
    else if (m_LineCells[p][0] >= 0)
    {
      const VertexTriple & cells = m_LineCells[p];
      m_Field.Project(mesh.points[p], { { cells[0], cells[1], cells[2], -1 } }, 3, Reach);
    }
  }
}

void
WallProjection::MoveWall(WallMesh & mesh, WallId wall) const
{
  const ImageFaces::Center * const begin = m_Faces.Begin(wall);
  const ImageFaces::Center * const end = m_Faces.End(wall);
  const std::vector<PointId> &     inner = m_Inner[wall];
  if (begin == end || inner.empty())
  {
    return;
  }
  std::vector<NearFaces> near(inner.size());
  for (const ImageFaces::Center * face = begin; face != end; ++face)
  {
    const Point center{ { (*face)[0], (*face)[1], (*face)[2] } };
    double      least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < inner.size(); ++i)
    {
      const Point  v = center - mesh.points[inner[i]];
      const double squared = Dot(v, v);
      if (squared < least)
      {
        least = squared;
        nearest = i;
      }
    }
    near[nearest].sum = near[nearest].sum + center;
    near[nearest].distance += std::sqrt(least);
    ++near[nearest].count;
  }
  const VertexPair & cells = m_WallCells[wall];
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    Point &    p = mesh.points[inner[i]];
    const auto count = static_cast<double>(near[i].count);
    const bool isFar = near[i].count > 0 && near[i].distance / count > m_EdgeLengths[wall];
    if (isFar)
    {
      p = (1.0 / count) * near[i].sum;
    }
    else if (!m_Field.Project(p, { { cells[0], cells[1], -1, -1 } }, 2, Reach) && near[i].count > 0)
    {
      p = (1.0 / count) * near[i].sum;
    }
  }
}
} // namespace tissue
