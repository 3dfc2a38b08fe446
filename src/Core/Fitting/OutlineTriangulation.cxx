/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/OutlineTriangulation.h"

#include "Geometry/PolygonTriangulation.h"
#include "Image/ImagePlaces.h"
#include "Mesh/WallLines.h"
#include "Mesh/WallPatch.h"
#include "Mesh/WallPieces.h"
#include "TissueTessellationCore/Geometry/Vector.h"

namespace tissue
{
namespace
{
/** Lists the points of the outline, by their numbers in the piece, in the order in which the outline meets them. */
std::vector<WallPatch::Vertex>
OrderOfOutline(const WallPatch & patch)
{
  std::vector<WallPatch::Vertex> order;
  WallPatch::Vertex              v = 0;
  do
  {
    order.push_back(v);
    v = patch.To(patch.Leaving(v));
  } while (v != 0);
  return order;
}

/** The outline of a wall with what its chords cost.
 *
 * The penalty of a chord is the square of its midpoint's distance to the nearest of the wall's faces, in tolerances. It
 * is infinite for a chord between two points that another wall has too: such a chord would be an edge of both. A
 * triangle costs its area times 1 + the mean penalty of its edges. */
class Outline
{
public:
  Outline(const WallMesh & mesh, const WallPiece & piece, const WallsAtPoints & wallsAt, const PlaceTree & faces,
          double tolerance)
    : m_Order(OrderOfOutline(MakePatch(mesh, piece)))
    , m_Penalty(m_Order.size() * m_Order.size(), 0.0)
  {
    for (const int v : m_Order)
    {
      m_Points.push_back(mesh.points[piece.outline[v]]);
    }
    const std::size_t n = m_Order.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      for (std::size_t k = i + 1; k < n; ++k)
      {
        const bool isSide = k == i + 1 || (i == 0 && k == n - 1);
        const bool isAllowed = isSide || wallsAt.CountCommon(piece.outline[m_Order[i]], piece.outline[m_Order[k]]) == 1;
        const double away = faces.DistanceToNearest(0.5 * (m_Points[i] + m_Points[k])) / tolerance;
        m_Penalty[i * n + k] = isAllowed ? away * away : std::numeric_limits<double>::infinity();
      }
    }
  }

  std::vector<std::array<std::int32_t, 3>>
  Triangulate() const
  {
    const auto                               n = static_cast<int>(m_Order.size());
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (const auto & t : LeastCostTriangulation(n, [this](int i, int j, int k) { return this->CostOf(i, j, k); }))
    {
      triangles.push_back({ { m_Order[t[0]], m_Order[t[1]], m_Order[t[2]] } });
    }
    return triangles;
  }

private:
  double
  CostOf(int i, int j, int k) const
  {
    const std::size_t n = m_Order.size();
    const double      penalty = m_Penalty[i * n + j] + m_Penalty[j * n + k] + m_Penalty[i * n + k];
    return TriangleArea(m_Points[i], m_Points[j], m_Points[k]) * (1.0 + penalty / 3.0);
  }

  std::vector<WallPatch::Vertex> m_Order;
  std::vector<Point>             m_Points;
  std::vector<double>            m_Penalty;
};

} // namespace

std::vector<WallId>
TriangulateFarOutlines(WallMesh & mesh, const ImagePlaces & faces, double tolerance, const Execution & execution)
{
  // Walls are cut out, and those far from their faces triangulated, one by one in parallel; then the mesh is joined
  // anew if there is a new wall.
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(mesh);
  const WallsAtPoints            wallsAt(mesh);
  std::vector<WallPiece>         pieces(mesh.walls.size());
  std::vector<unsigned char>     isNew(mesh.walls.size(), 0);
  execution.For(pieces.size(), [&](std::size_t w) {
    pieces[w] = CutOutWall(mesh, first[w], first[w + 1]);
    const PlaceTree       places(faces.Begin(w), faces.End(w));
    const AreaAndDistance sums = IntegrateDistance(mesh.points, mesh.triangles, first[w], first[w + 1], places);
    if (places.IsEmpty() || !(sums.distance > tolerance * sums.area))
    {
      return;
    }
    auto triangles = Outline(mesh, pieces[w], wallsAt, places, tolerance).Triangulate();
    if (!triangles.empty())
    {
      pieces[w].interior.clear();
      pieces[w].triangles = std::move(triangles);
      isNew[w] = 1;
    }
  });
  std::vector<WallId> walls;
  for (std::size_t w = 0; w < isNew.size(); ++w)
  {
    if (isNew[w] != 0)
    {
      walls.push_back(static_cast<WallId>(w));
    }
  }
  if (!walls.empty())
  {
    mesh = JoinWallPieces(mesh, pieces);
  }
  return walls;
}
} // namespace tissue
