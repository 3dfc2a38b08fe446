/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/WallProjection.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** How far a point may move to where its cells' indicators are equal, in voxels. The spline reaches two voxels along
 * each axis, so that a place much farther off cannot be told from where the point is. */
constexpr double Reach = 3.0;
/** The share of the way to its given place that a corner goes in one move. Moves are repeated, and the points about the
 * corner follow between them; a whole step would leave them behind and turn triangles over. */
constexpr double CornerShare = 0.5;
/** The number of walls and lines that a thread takes at a time: enough to make up for the handing out, and few enough
 * for all threads to end together. */
constexpr std::size_t GroupsPerTask = 64;

/** The places of the image that are nearer to a point than to the others of its group: their sum, the sum of their
 * distances to the point, and their number. */
struct NearPlaces
{
  Point        sum{ { 0.0, 0.0, 0.0 } };
  double       distance = 0.0;
  std::int64_t count = 0;
};

Point
ToPoint(const ImagePlaces::Place & place)
{
  return { { place[0], place[1], place[2] } };
}

/** Gives each place of the image to the nearest point of the group. */
std::vector<NearPlaces>
Assign(const ImagePlaces::Place * begin, const ImagePlaces::Place * end, const std::vector<PointId> & group,
       const std::vector<Point> & points)
{
  std::vector<NearPlaces> near(group.size());
  for (const ImagePlaces::Place * at = begin; at != end; ++at)
  {
    const Point place = ToPoint(*at);
    double      least = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      const Point  v = place - points[group[i]];
      const double squared = Dot(v, v);
      if (squared < least)
      {
        least = squared;
        nearest = i;
      }
    }
    near[nearest].sum = near[nearest].sum + place;
    near[nearest].distance += std::sqrt(least);
    ++near[nearest].count;
  }
  return near;
}

Point
Nearest(const ImagePlaces::Place * begin, const ImagePlaces::Place * end, const Point & p)
{
  return ToPoint(*std::min_element(begin, end, [&p](const ImagePlaces::Place & a, const ImagePlaces::Place & b) {
    return Distance(ToPoint(a), p) < Distance(ToPoint(b), p);
  }));
}

/** Finds the vertices of the complex at each point of a line or corner, -1 for fewer than four. */
std::map<PointId, VertexQuadruple>
VerticesAtPoints(const WallMesh & mesh, const std::vector<VertexPair> & pairs)
{
  std::map<PointId, CellsAtPoint> at;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      if (mesh.numberOfCells[p] != CellsWithinWall)
      {
        CellsAtPoint & vertices = at[p];
        vertices.Add(pairs[mesh.wallOfTriangle[t]][0]);
        vertices.Add(pairs[mesh.wallOfTriangle[t]][1]);
      }
    }
  }
  std::map<PointId, VertexQuadruple> verticesAt;
  for (const auto & [p, vertices] : at)
  {
    verticesAt[p] = vertices.cells;
  }
  return verticesAt;
}
} // namespace

WallProjection::WallProjection(const WallMesh & mesh, const ComplexImage & complex, const IndicatorField & field,
                               const ImagePlaces & faces, const std::vector<double> & edgeLengths,
                               const std::vector<Point> & corners)
  : m_Complex(complex)
  , m_Field(field)
  , m_Faces(faces)
  , m_Corners(corners)
  , m_LinePlaces(0, {})
{
  this->CollectLines(mesh);
  this->SetWalls(mesh, edgeLengths);
}

void
WallProjection::CollectLines(const WallMesh & mesh)
{
  std::map<VertexTriple, std::vector<PointId>> pointsOf;
  for (const auto & [p, vertices] : VerticesAtPoints(mesh, m_Complex.pairs))
  {
    if (mesh.numberOfCells[p] == CellsAtCorner)
    {
      m_CellsAtCorners.push_back(CellsOfVertices(vertices, m_Complex.cellOf));
    }
    else
    {
      VertexTriple line{ { vertices[0], vertices[1], vertices[2] } };
      std::sort(line.begin(), line.end());
      pointsOf[line].push_back(p);
    }
  }
  std::vector<VertexTriple> lines;
  for (const auto & line : pointsOf)
  {
    lines.push_back(line.first);
  }
  m_LinePlaces = CollectImageLines(m_Complex.volume, lines);
  for (std::size_t l = 0; l < lines.size(); ++l)
  {
    m_Lines.push_back({ CellsOfVertices(lines[l], m_Complex.cellOf),
                        lines[l],
                        0.0,
                        pointsOf[lines[l]],
                        m_LinePlaces.Begin(l),
                        m_LinePlaces.End(l) });
  }
  // The lines come in the order of the mesh's points, so that what is near in the tissue is near in memory.
  std::sort(m_Lines.begin(), m_Lines.end(), [](const Group & a, const Group & b) {
    return a.points.front() < b.points.front();
  });
}

void
WallProjection::SetWalls(const WallMesh & mesh, const std::vector<double> & edgeLengths)
{
  // Each wall makes a group, of the points within it and its faces in the image. The groups of the lines are kept from
  // the constructor, and only get their edge length anew: the least of their walls'.
  std::map<VertexPair, double> lengthOf;
  m_Groups.assign(mesh.walls.size(), {});
  for (std::size_t w = 0; w < mesh.walls.size(); ++w)
  {
    VertexPair pair = m_Complex.pairs[w];
    m_Groups[w] = { CellsOfVertices(pair, m_Complex.cellOf), {}, edgeLengths[w], {}, m_Faces.Begin(w), m_Faces.End(w) };
    std::sort(pair.begin(), pair.end());
    double & length = lengthOf.emplace(pair, edgeLengths[w]).first->second;
    length = std::min(length, edgeLengths[w]);
  }
  std::vector<unsigned char> isDone(mesh.points.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const PointId p : mesh.triangles[t])
    {
      if (mesh.numberOfCells[p] == CellsWithinWall && isDone[p] == 0)
      {
        isDone[p] = 1;
        m_Groups[mesh.wallOfTriangle[t]].points.push_back(p);
      }
    }
  }
  for (Group & line : m_Lines)
  {
    line.edgeLength = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
    {
      const auto [u, v] = std::minmax(line.vertices[i], line.vertices[(i + 1) % 3]);
      const auto length = lengthOf.find({ { u, v } });
      line.edgeLength = std::min(line.edgeLength, length != lengthOf.end() ? length->second : line.edgeLength);
    }
    m_Groups.push_back(line);
  }
}

void
WallProjection::Move(WallMesh & mesh, const Execution & execution) const
{
  for (std::size_t p = 0; p < m_Corners.size(); ++p)
  {
    const CellsAtPoint & at = m_CellsAtCorners[p];
    if (at.count == 4 || !m_Field.Project(mesh.points[p], at.cells, at.count, Reach))
    {
      mesh.points[p] = mesh.points[p] + CornerShare * (m_Corners[p] - mesh.points[p]);
    }
  }
  execution.For((m_Groups.size() + GroupsPerTask - 1) / GroupsPerTask, [&](std::size_t task) {
    for (std::size_t g = task * GroupsPerTask; g < std::min(m_Groups.size(), (task + 1) * GroupsPerTask); ++g)
    {
      this->MoveGroup(m_Groups[g], mesh);
    }
  });
}

void
WallProjection::MoveGroup(const Group & group, WallMesh & mesh) const
{
  if (group.begin == group.end || group.points.empty())
  {
    return;
  }
  // A point follows the indicators, but where the places nearest to it are far, or no indicator reaches it, it goes to
  // their centroid, and to the single nearest place if it has none.
  const std::vector<NearPlaces> near = Assign(group.begin, group.end, group.points, mesh.points);
  for (std::size_t i = 0; i < group.points.size(); ++i)
  {
    Point &    p = mesh.points[group.points[i]];
    const auto count = static_cast<double>(near[i].count);
    const bool isFar = near[i].count > 0 && near[i].distance > count * group.edgeLength;
    if (isFar || !m_Field.Project(p, group.at.cells, group.at.count, Reach))
    {
      p = near[i].count > 0 ? (1.0 / count) * near[i].sum : Nearest(group.begin, group.end, p);
    }
  }
}
} // namespace tissue
