/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Dual/EmbeddedWalls.h"

#include "Complex/AdjacencyComplex.h"
#include "Nerve/KuhnSimplex.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace tissue
{
namespace
{
/** The place of a simplex: twelve times the mean of its voxels, which is whole, as one number. */
using Key = std::int64_t;

/** The middle of a simplex across whose voxels cells meet. Those of four cells come first, by these, then those of
 * three. */
struct SimplexPoint
{
  Key             key;
  int             numberOfCells;
  VertexQuadruple cells; // of four cells

  bool
  operator<(const SimplexPoint & other) const
  {
    return std::make_tuple(-numberOfCells, cells, key) < std::make_tuple(-other.numberOfCells, other.cells, other.key);
  }

  bool
  operator==(const SimplexPoint & other) const
  {
    return key == other.key;
  }
};

/** A triangle from the middle of an edge to that of a triangle and that of a tetrahedron. */
struct Facet
{
  VertexPair         cells;
  std::array<Key, 3> corners;
};

/** A tetrahedron with the cells of its voxels. */
struct CellSimplex
{
  KuhnSimplex     simplex;
  VertexQuadruple cells;
};

/** Calls visit(simplex) for each tetrahedron of several cells, in raster order of their first voxels. */
template <typename TVisit>
void
VisitSimplices(const LabelVolume & volume, const std::vector<VertexId> & cellOf, const TVisit & visit)
{
  const auto cellAt = [&](const VoxelIndex & v) { return cellOf[volume.At(v[0], v[1], v[2])]; };
  VoxelIndex base;
  for (base[2] = -1; base[2] < volume.size[2]; ++base[2])
  {
    for (base[1] = -1; base[1] < volume.size[1]; ++base[1])
    {
      for (base[0] = -1; base[0] < volume.size[0]; ++base[0])
      {
        bool           isUniform = true;
        const VertexId first = cellAt(base);
        for (int corner = 1; isUniform && corner < 8; ++corner)
        {
          isUniform = cellAt({ { base[0] + corner % 2, base[1] + corner / 2 % 2, base[2] + corner / 4 } }) == first;
        }
        for (int way = 0; !isUniform && way < 6; ++way)
        {
          CellSimplex s;
          s.simplex = KuhnSimplex::FromWay(base, way / 2, (way / 2 + 1 + way % 2) % 3);
          std::transform(s.simplex.voxels.begin(), s.simplex.voxels.end(), s.cells.begin(), cellAt);
          if (s.cells != VertexQuadruple{ { s.cells[0], s.cells[0], s.cells[0], s.cells[0] } })
          {
            visit(s);
          }
        }
      }
    }
  }
}

/** \brief Collects the points and triangles between the cells. */
class Embedding
{
public:
  Embedding(const LabelVolume & volume, const std::vector<VertexId> & cellOf)
    : m_Volume(volume)
  {
    VisitSimplices(volume, cellOf, [this](const CellSimplex & s) { this->Add(s); });
    std::sort(m_Points.begin(), m_Points.end());
    m_Points.erase(std::unique(m_Points.begin(), m_Points.end()), m_Points.end());
  }

  EmbeddedWalls
  Make()
  {
    EmbeddedWalls result;
    WallMesh &    mesh = result.mesh;
    this->NumberPoints();
    for (const SimplexPoint & point : m_Points)
    {
      mesh.points.push_back(this->PositionOf(point.key));
      mesh.numberOfCells.push_back(static_cast<std::uint8_t>(point.numberOfCells));
      if (point.numberOfCells == CellsAtCorner)
      {
        result.tetrahedra.push_back(point.cells);
      }
    }
    this->AddTriangles(mesh);
    return result;
  }

private:
  /** The middle of the voxels of a simplex given by the numbers of `count` of them. */
  Key
  KeyOf(const KuhnSimplex & simplex, const std::array<int, 4> & vertices, int count) const
  {
    VoxelIndex sum{ { 0, 0, 0 } };
    for (int i = 0; i < count; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += simplex.voxels[vertices[i]][axis] + 1;
      }
    }
    const int parts = Parts / count;
    return (Key{ parts * sum[2] } * this->Extent(1) + parts * sum[1]) * this->Extent(0) + parts * sum[0];
  }

  Key
  Extent(int axis) const
  {
    return Key{ Parts } * (m_Volume.size[axis] + 2);
  }

  Point
  PositionOf(Key key) const
  {
    const auto coordinate = [](Key k) { return static_cast<double>(k) / Parts - 1.0; };
    const Key  rows = key / this->Extent(0);
    return m_Volume.ToPhysical({ { coordinate(key % this->Extent(0)),
                                   coordinate(rows % this->Extent(1)),
                                   coordinate(rows / this->Extent(1)) } });
  }

  void
  Add(const CellSimplex & s)
  {
    const Key whole = this->AddPoint(s, { { 0, 1, 2, 3 } }, 4);
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        if (s.cells[i] != s.cells[j])
        {
          this->AddFacets(s, i, j, whole);
        }
      }
    }
  }

  /** The two triangles across the edge of two voxels of different cells. */
  void
  AddFacets(const CellSimplex & s, int i, int j, Key whole)
  {
    const bool isInOrder = IsFirst(s.cells[i], s.cells[j]);
    const int  from = isInOrder ? i : j;
    const int  to = isInOrder ? j : i;
    const Key  middle = this->AddPoint(s, { { i, j, 0, 0 } }, 2);
    for (int k = 0; k < 4; ++k)
    {
      if (k == i || k == j)
      {
        continue;
      }
      const Key  face = this->AddPoint(s, { { i, j, k, 0 } }, 3);
      const auto at = [&](int v) {
        const VoxelIndex & voxel = s.simplex.voxels[v];
        return m_Volume.ToPhysical({ { double(voxel[0]), double(voxel[1]), double(voxel[2]) } });
      };
      const Point m = this->PositionOf(middle);
      const Point normal = Cross(this->PositionOf(face) - m, this->PositionOf(whole) - m);
      const bool  isAlong = Dot(normal, at(to) - at(from)) > 0.0;
      m_Facets.push_back(
        { { { s.cells[from], s.cells[to] } },
          isAlong ? std::array<Key, 3>{ { middle, face, whole } } : std::array<Key, 3>{ { middle, whole, face } } });
      // Around a triangle of two cells their wall goes on.
      const int other = s.cells[k] == s.cells[i] ? j : i;
      if (s.cells[k] == s.cells[i] || s.cells[k] == s.cells[j])
      {
        m_Links.push_back({ { middle, this->KeyOf(s.simplex, { { k, other, 0, 0 } }, 2) } });
      }
    }
  }

  /** Which cell of a wall comes first, as WallMesh has it. */
  static bool
  IsFirst(VertexId a, VertexId b)
  {
    return b == ExteriorVertex || (a != ExteriorVertex && a < b);
  }

  Key
  AddPoint(const CellSimplex & s, const std::array<int, 4> & vertices, int count)
  {
    SimplexPoint point{ this->KeyOf(s.simplex, vertices, count), 0, { { 0, 0, 0, 0 } } };
    for (int i = 0; i < count; ++i)
    {
      int before = 0;
      while (s.cells[vertices[before]] != s.cells[vertices[i]])
      {
        ++before;
      }
      point.numberOfCells += before == i ? 1 : 0;
    }
    if (point.numberOfCells == CellsAtCorner)
    {
      point.cells = this->OrientedCells(s);
    }
    m_Points.push_back(point);
    return point.key;
  }

  VertexQuadruple
  OrientedCells(const CellSimplex & s) const
  {
    std::array<Point, 4> at;
    for (int i = 0; i < 4; ++i)
    {
      const VoxelIndex & voxel = s.simplex.voxels[i];
      at[i] = m_Volume.ToPhysical({ { double(voxel[0]), double(voxel[1]), double(voxel[2]) } });
    }
    VertexQuadruple cells = s.cells;
    if (Dot(at[1] - at[0], Cross(at[2] - at[0], at[3] - at[0])) < 0.0)
    {
      std::swap(cells[2], cells[3]);
    }
    return Canonical(cells);
  }

  void
  NumberPoints()
  {
    for (std::size_t p = 0; p < m_Points.size(); ++p)
    {
      m_Numbers.push_back({ m_Points[p].key, static_cast<PointId>(p) });
    }
    std::sort(m_Numbers.begin(), m_Numbers.end());
  }

  PointId
  NumberOf(Key key) const
  {
    return std::lower_bound(m_Numbers.begin(), m_Numbers.end(), std::make_pair(key, PointId{ 0 }))->second;
  }

  void
  AddTriangles(WallMesh & mesh)
  {
    DisjointSets sets(m_Points.size());
    for (const std::array<Key, 2> & link : m_Links)
    {
      sets.Unite(this->NumberOf(link[0]), this->NumberOf(link[1]));
    }
    // Walls by their cells, then by their first points.
    std::vector<std::tuple<VertexPair, std::int64_t, std::size_t>> order;
    for (std::size_t f = 0; f < m_Facets.size(); ++f)
    {
      order.push_back({ m_Facets[f].cells, sets.Find(this->NumberOf(m_Facets[f].corners[0])), f });
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const auto & [cells, set, f] = order[i];
      if (i == 0 || std::get<1>(order[i - 1]) != set)
      {
        mesh.walls.push_back({ cells });
      }
      const std::array<Key, 3> & corners = m_Facets[f].corners;
      mesh.triangles.push_back(
        { { this->NumberOf(corners[0]), this->NumberOf(corners[1]), this->NumberOf(corners[2]) } });
      mesh.wallOfTriangle.push_back(static_cast<WallId>(mesh.walls.size() - 1));
    }
  }

  /** The means of two, three and four whole numbers are whole in units of a twelfth. */
  static constexpr int Parts = 12;

  const LabelVolume &                  m_Volume;
  std::vector<SimplexPoint>            m_Points;
  std::vector<Facet>                   m_Facets;
  std::vector<std::array<Key, 2>>      m_Links;
  std::vector<std::pair<Key, PointId>> m_Numbers;
};
} // namespace

EmbeddedWalls
MakeEmbeddedWalls(const LabelVolume & volume, const std::vector<VertexId> & cellOf)
{
  return Embedding(volume, cellOf).Make();
}

std::int64_t
CountEmbeddedTriangles(const LabelVolume & volume, const std::vector<VertexId> & cellOf)
{
  std::int64_t count = 0;
  VisitSimplices(volume, cellOf, [&count](const CellSimplex & s) {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        count += s.cells[i] != s.cells[j] ? 2 : 0;
      }
    }
  });
  return count;
}
} // namespace tissue
