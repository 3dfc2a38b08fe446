/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/LinkLoop.h"

#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <deque>
#include <set>

namespace tissue
{
namespace
{
/** Shortest paths from one vertex of a link to all others. */
class PathTree
{
public:
  PathTree(const GeneralComplex & complex, const LinkSurface & surface, std::int32_t root)
    : m_Complex(complex)
    , m_Surface(surface)
    , m_Steps(surface.GetEdges().size())
  {
    std::deque<std::int32_t> open{ root };
    m_Steps[static_cast<std::size_t>(root)].parent = root;
    while (!open.empty())
    {
      const std::int32_t v = open.front();
      open.pop_front();
      for (const RingStep & step : complex.GetRing(surface.GetEdges()[static_cast<std::size_t>(v)]))
      {
        const std::int32_t next = surface.FindEdge(step.tetrahedron, step.here);
        Step &             of = m_Steps[static_cast<std::size_t>(next)];
        if (of.parent < 0)
        {
          of = { v, { step.tetrahedron, step.next }, m_Steps[static_cast<std::size_t>(v)].depth + 1 };
          m_Triangles.insert(this->Key(of.triangle));
          open.push_back(next);
        }
      }
    }
  }

  bool
  Contains(const Side & triangle) const
  {
    return m_Triangles.count(this->Key(triangle)) != 0;
  }

  /** A triangle by one of its two sides, always the same. */
  std::pair<TetrahedronId, int>
  Key(const Side & triangle) const
  {
    const Side mate = m_Complex.GetMate(triangle);
    return std::min(std::pair(triangle.tetrahedron, triangle.opposite), std::pair(mate.tetrahedron, mate.opposite));
  }

  /** The loop of an edge of the link from u to v and the paths to where they meet. */
  LinkLoop
  Close(const Side & triangle, std::int32_t u, std::int32_t v) const
  {
    LinkLoop ofU;
    LinkLoop ofV;
    while (u != v)
    {
      const bool isUDeeper = m_Steps[static_cast<std::size_t>(u)].depth >= m_Steps[static_cast<std::size_t>(v)].depth;
      std::int32_t & deeper = isUDeeper ? u : v;
      LinkLoop &     path = isUDeeper ? ofU : ofV;
      const Step &   step = m_Steps[static_cast<std::size_t>(deeper)];
      path.triangles.push_back(step.triangle);
      path.vertices.push_back(this->EndOf(deeper));
      deeper = step.parent;
    }
    // From u up to the common vertex, down to v, and back by the triangle.
    LinkLoop loop = ofU;
    loop.vertices.push_back(this->EndOf(u));
    loop.vertices.insert(loop.vertices.end(), ofV.vertices.rbegin(), ofV.vertices.rend());
    loop.triangles.insert(loop.triangles.end(), ofV.triangles.rbegin(), ofV.triangles.rend());
    loop.triangles.push_back(triangle);
    return loop;
  }

private:
  /** How a vertex of the link is reached. */
  struct Step
  {
    std::int32_t parent = -1;
    Side         triangle;
    std::int32_t depth = 0;
  };

  VertexId
  EndOf(std::int32_t v) const
  {
    const LocalEdge & edge = m_Surface.GetEdges()[static_cast<std::size_t>(v)];
    return m_Complex.GetTetrahedron(edge.tetrahedron).vertices[edge.to];
  }

  const GeneralComplex &                  m_Complex;
  const LinkSurface &                     m_Surface;
  std::vector<Step>                       m_Steps;
  std::set<std::pair<TetrahedronId, int>> m_Triangles;
};

/** The shortest loop that the edges close which are in neither tree. */
LinkLoop
ShortestLoop(const GeneralComplex & complex, const LinkSurface & surface, const PathTree & tree)
{
  LinkLoop     shortest;
  DisjointSets joined(static_cast<std::size_t>(complex.TetrahedronIdBound()));
  for (const Side & apex : surface.GetTriangles())
  {
    for (int j = 0; j < 4; ++j)
    {
      const Side side{ apex.tetrahedron, j };
      if (j == apex.opposite || tree.Key(side) != std::pair(side.tetrahedron, side.opposite) || tree.Contains(side))
      {
        continue;
      }
      const TetrahedronId other = complex.GetMate(side).tetrahedron;
      if (joined.Find(side.tetrahedron) != joined.Find(other))
      {
        joined.Unite(side.tetrahedron, other);
        continue;
      }
      const auto     ends = EvenComplement(apex.opposite, j);
      const LinkLoop loop =
        tree.Close(side, surface.FindEdge(side.tetrahedron, ends[0]), surface.FindEdge(side.tetrahedron, ends[1]));
      if (shortest.triangles.empty() || loop.triangles.size() < shortest.triangles.size())
      {
        shortest = loop;
      }
    }
  }
  return shortest;
}
} // namespace

LinkLoop
FindHandleLoop(const GeneralComplex & complex, const LinkSurface & surface)
{
  // Roots that are tried: a handle's shortest loop is missed at most where the cell has more neighbours than this.
  constexpr std::size_t maximumNumberOfRoots = 64;
  LinkLoop              shortest;
  for (std::size_t root = 0; root < std::min(maximumNumberOfRoots, surface.GetEdges().size()); ++root)
  {
    const PathTree tree(complex, surface, static_cast<std::int32_t>(root));
    const LinkLoop loop = ShortestLoop(complex, surface, tree);
    if (!loop.triangles.empty() && (shortest.triangles.empty() || loop.triangles.size() < shortest.triangles.size()))
    {
      shortest = loop;
    }
  }
  return shortest;
}
} // namespace tissue
