/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CavityVolumes.h"

#include "Image/ImageVoids.h"
#include "TissueTessellationCore/Common/DisjointSets.h"
#include "TissueTessellationCore/Geometry/Box.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tissue
{
namespace
{
/** A piece of the surface between the tissue and the exterior. */
struct SurfacePiece
{
  /** Its only cell; ExteriorVertex before it is known, and where there are several. */
  VertexId cell = ExteriorVertex;
  bool     hasOneCell = true;
  /** Six times the volume on the other side of the normals. */
  double             volume = 0.0;
  std::optional<Box> box;

  void
  Add(const WallMesh & mesh, const Triangle & triangle, VertexId cellOfTriangle)
  {
    hasOneCell = hasOneCell && (cell == ExteriorVertex || cell == cellOfTriangle);
    cell = cellOfTriangle;
    const Point & origin = mesh.points[triangle[0]];
    box = box.value_or(Box{ origin, origin });
    for (const PointId p : triangle)
    {
      Extend(*box, mesh.points[p]);
    }
    volume += Dot(origin, Cross(mesh.points[triangle[1]], mesh.points[triangle[2]]));
  }

  bool
  IsCavity() const
  {
    return box && hasOneCell && volume < 0.0;
  }
};

bool
IsWithin(const Point & p, const Box & box, double margin)
{
  for (int i = 0; i < 3; ++i)
  {
    if (p[i] < box.lower[i] - margin || p[i] > box.upper[i] + margin)
    {
      return false;
    }
  }
  return true;
}

/** \brief The cavities of a mesh, and the voids of the image that they are. */
class CavityFinder
{
public:
  CavityFinder(const WallMesh & mesh, std::size_t numberOfVertices)
    : m_Sets(mesh.points.size())
    , m_Pieces(mesh.points.size())
  {
    m_Result.ofWall.assign(mesh.walls.size(), ExteriorVertex);
    VisitSurface(mesh, [this](std::size_t, const Triangle & triangle, VertexId) {
      m_Sets.Unite(triangle[0], triangle[1]);
      m_Sets.Unite(triangle[0], triangle[2]);
    });
    VisitSurface(mesh, [&](std::size_t, const Triangle & triangle, VertexId cell) {
      m_Pieces[this->PieceOf(triangle)].Add(mesh, triangle, cell);
    });
    for (std::size_t piece = 0; piece < m_Pieces.size(); ++piece)
    {
      if (m_Pieces[piece].IsCavity())
      {
        m_Cavities.push_back(piece);
      }
    }
    std::stable_sort(m_Cavities.begin(), m_Cavities.end(), [this](std::size_t a, std::size_t b) {
      return m_Pieces[a].cell < m_Pieces[b].cell;
    });
    std::vector<VertexId> numbers(m_Pieces.size(), ExteriorVertex);
    for (std::size_t c = 0; c < m_Cavities.size(); ++c)
    {
      numbers[m_Cavities[c]] = static_cast<VertexId>(numberOfVertices + c);
    }
    VisitSurface(mesh, [&](std::size_t wall, const Triangle & triangle, VertexId) {
      m_Result.ofWall[wall] = numbers[this->PieceOf(triangle)];
    });
    m_Result.volumes.assign(m_Cavities.size(), 0.0);
  }

  CavityVolumes
  TakeVoids(const LabelVolume & cells)
  {
    const double length = cells.VoxelLength();
    for (const ImageVoid & hole : FindVoidsInCells(cells))
    {
      const Point first = cells.ToPhysical({ { static_cast<double>(hole.first[0]),
                                               static_cast<double>(hole.first[1]),
                                               static_cast<double>(hole.first[2]) } });
      const auto  cavity = this->FindCavity(hole.cell, first, length);
      if (cavity)
      {
        m_Result.volumes[*cavity] += static_cast<double>(hole.voxels) * length * length * length;
      }
      else
      {
        m_Result.cellsOfFilledVoids.push_back(hole.cell);
      }
    }
    auto & filled = m_Result.cellsOfFilledVoids;
    std::sort(filled.begin(), filled.end());
    return std::move(m_Result);
  }

private:
  /** Calls visit(wall, triangle, cell) for all triangles between a cell and the exterior. */
  template <typename TVisitor>
  static void
  VisitSurface(const WallMesh & mesh, const TVisitor & visit)
  {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      const auto         wall = static_cast<std::size_t>(mesh.wallOfTriangle[t]);
      const VertexPair & cells = mesh.walls[wall].cells;
      if (cells[1] == ExteriorVertex)
      {
        visit(wall, mesh.triangles[t], cells[0]);
      }
    }
  }

  std::size_t
  PieceOf(const Triangle & triangle)
  {
    return static_cast<std::size_t>(m_Sets.Find(triangle[0]));
  }

  std::optional<std::size_t>
  FindCavity(VertexId cell, const Point & place, double margin) const
  {
    std::optional<std::size_t> found;
    const auto isBefore = [this](std::size_t cavity, VertexId other) { return m_Pieces[cavity].cell < other; };
    const auto begin = std::lower_bound(m_Cavities.begin(), m_Cavities.end(), cell, isBefore);
    for (auto at = begin; at != m_Cavities.end() && m_Pieces[*at].cell == cell; ++at)
    {
      const bool isSmaller = !found || m_Pieces[*at].volume > m_Pieces[m_Cavities[*found]].volume;
      if (isSmaller && IsWithin(place, *m_Pieces[*at].box, margin))
      {
        found = static_cast<std::size_t>(at - m_Cavities.begin());
      }
    }
    return found;
  }

  DisjointSets              m_Sets;
  std::vector<SurfacePiece> m_Pieces;
  /** The pieces that are cavities, by their cells. */
  std::vector<std::size_t> m_Cavities;
  CavityVolumes            m_Result;
};
} // namespace

CavityVolumes
FindCavityVolumes(const WallMesh & mesh, std::size_t numberOfVertices, const LabelVolume & cells)
{
  return CavityFinder(mesh, numberOfVertices).TakeVoids(cells);
}
} // namespace tissue
