/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/ComplexValidity.h"

#include <algorithm>
#include <map>
#include <set>

namespace tissue
{
namespace
{
template <typename T>
std::string
Text(const T & vertices)
{
  std::string text = "(";
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    text += (i > 0 ? ", " : "") + std::to_string(vertices[i]);
  }
  return text + ")";
}

template <typename T>
T
Ascending(T vertices)
{
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

using Adjacency = std::map<VertexId, std::set<VertexId>>;

/** Returns the number of connected components, counted by a walk from each vertex that no walk has reached. */
std::size_t
CountComponents(const Adjacency & adjacent)
{
  std::set<VertexId> reached;
  std::size_t        components = 0;
  for (const auto & [start, unused] : adjacent)
  {
    components += reached.count(start) == 0 ? 1 : 0;
    std::vector<VertexId> open{ start };
    while (!open.empty())
    {
      const VertexId u = open.back();
      open.pop_back();
      if (reached.insert(u).second)
      {
        open.insert(open.end(), adjacent.at(u).begin(), adjacent.at(u).end());
      }
    }
  }
  return components;
}

/** Collects all violations: what each tetrahedron shows by itself is checked first, while triangles, edges and links
 * are counted; then what the counts show. */
class Check
{
public:
  explicit Check(const AdjacencyComplex & complex)
    : m_Complex(complex)
    , m_Star(static_cast<std::size_t>(complex.NumberOfVertices()))
  {}

  std::vector<std::string>
  Run()
  {
    for (TetrahedronId id = 0; id < m_Complex.TetrahedronIdBound(); ++id)
    {
      if (m_Complex.IsAlive(id))
      {
        CheckTetrahedron(id);
      }
    }
    CheckTriangles();
    CheckEdges();
    for (VertexId v = 0; v < m_Complex.NumberOfVertices(); ++v)
    {
      CheckLink(v);
    }
    CheckConnected();
    if (m_Violations.empty())
    {
      CheckRings();
    }
    return m_Violations;
  }

private:
  void
  CheckTetrahedron(TetrahedronId id)
  {
    const auto & t = m_Complex.GetTetrahedron(id);
    const auto   key = Ascending(t.vertices);
    if (std::adjacent_find(key.begin(), key.end()) != key.end())
    {
      m_Violations.push_back("tetrahedron " + Text(t.vertices) + " has a vertex twice");
    }
    if (!m_Keys.insert(key).second)
    {
      m_Violations.push_back("tetrahedron " + Text(key) + " exists twice");
    }
    for (int i = 0; i < 4; ++i)
    {
      ++m_Triangles[Ascending(TriangleOpposite(t.vertices, i))];
      m_Star[t.vertices[i]].push_back(TriangleOpposite(t.vertices, i));
      for (int j = i + 1; j < 4; ++j)
      {
        ++m_Degrees[Ascending(VertexPair{ { t.vertices[i], t.vertices[j] } })];
      }
      CheckNeighbor(id, i);
    }
  }

  void
  CheckNeighbor(TetrahedronId id, int i)
  {
    const auto &        t = m_Complex.GetTetrahedron(id);
    const TetrahedronId neighbor = t.neighbors[i];
    if (neighbor < 0 || neighbor >= m_Complex.TetrahedronIdBound() || !m_Complex.IsAlive(neighbor))
    {
      m_Violations.push_back("tetrahedron " + Text(t.vertices) + " has no neighbour " + std::to_string(i));
      return;
    }
    const auto & other = m_Complex.GetTetrahedron(neighbor);
    auto         here = TriangleOpposite(t.vertices, i);
    int          at = 0;
    while (at < 4 && (other.neighbors[at] != id || Ascending(TriangleOpposite(other.vertices, at)) != Ascending(here)))
    {
      ++at;
    }
    if (at == 4)
    {
      m_Violations.push_back("neighbours " + Text(t.vertices) + " and " + Text(other.vertices) + " are not symmetric");
      return;
    }
    // The common triangle must appear with opposite orientations from its two sides.
    const auto there = TriangleOpposite(other.vertices, at);
    std::swap(here[1], here[2]);
    std::rotate(here.begin(), std::find(here.begin(), here.end(), there[0]), here.end());
    if (here != there)
    {
      m_Violations.push_back("neighbours " + Text(t.vertices) + " and " + Text(other.vertices) +
                             " are not oriented alike");
    }
  }

  void
  CheckTriangles()
  {
    for (const auto & [triangle, count] : m_Triangles)
    {
      if (count != 2)
      {
        m_Violations.push_back("triangle " + Text(triangle) + " is in " + std::to_string(count) + " tetrahedra");
      }
    }
  }

  /** The records of edges and of numbers of neighbours must agree with the edges that the tetrahedra have. */
  void
  CheckEdges()
  {
    if (m_Complex.NumberOfEdges() != m_Degrees.size())
    {
      m_Violations.push_back(std::to_string(m_Complex.NumberOfEdges()) + " edges are counted, " +
                             std::to_string(m_Degrees.size()) + " exist");
    }
    std::vector<std::int32_t> neighbors(static_cast<std::size_t>(m_Complex.NumberOfVertices()), 0);
    for (const auto & [edge, degree] : m_Degrees)
    {
      ++neighbors[edge[0]];
      ++neighbors[edge[1]];
      const auto * const record = m_Complex.FindEdge(edge[0], edge[1]);
      if (!record || record->degree != degree)
      {
        m_Violations.push_back("edge " + Text(edge) + " has " + std::to_string(degree) +
                               " tetrahedra, its record says " + std::to_string(record ? record->degree : 0));
      }
      else
      {
        const auto & t = m_Complex.GetTetrahedron(record->incident).vertices;
        if (!m_Complex.IsAlive(record->incident) || std::count(t.begin(), t.end(), edge[0]) == 0 ||
            std::count(t.begin(), t.end(), edge[1]) == 0)
        {
          m_Violations.push_back("edge " + Text(edge) + " names a tetrahedron that is not incident to it");
        }
      }
    }
    for (VertexId v = 0; v < m_Complex.NumberOfVertices(); ++v)
    {
      if (neighbors[v] != m_Complex.NumberOfNeighbors(v))
      {
        m_Violations.push_back("vertex " + std::to_string(v) + " has " + std::to_string(neighbors[v]) +
                               " neighbours, its record says " + std::to_string(m_Complex.NumberOfNeighbors(v)));
      }
    }
  }

  /** The tetrahedra around an edge must be one cycle, so that no vertex of a link is pinched. The check walks through
   * the complex, so that everything else must be in order. */
  void
  CheckRings()
  {
    for (const auto & [edge, degree] : m_Degrees)
    {
      if (static_cast<std::int32_t>(m_Complex.GetRing(edge[0], edge[1]).vertices.size()) != degree)
      {
        m_Violations.push_back("the tetrahedra around edge " + Text(edge) + " are not one cycle");
      }
    }
  }

  /** The link of a vertex must be a sphere, which a connected closed surface without pinched vertices (CheckRings) is
   * where its numbers of vertices, edges and triangles give V - E + F = 2. That of the exterior must be as many spheres
   * as the tissue has parts. */
  void
  CheckLink(VertexId v)
  {
    const auto & triangles = m_Star[v];
    Adjacency    adjacent;
    for (const VertexTriple & t : triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        adjacent[t[k]].insert(t[(k + 1) % 3]);
        adjacent[t[(k + 1) % 3]].insert(t[k]);
      }
    }
    if (adjacent.empty())
    {
      m_Violations.push_back("vertex " + std::to_string(v) + " is in no tetrahedron");
      return;
    }
    std::size_t halfEdges = 0;
    for (const auto & [u, others] : adjacent)
    {
      halfEdges += others.size();
    }
    const auto euler =
      static_cast<long>(adjacent.size()) - static_cast<long>(halfEdges / 2) + static_cast<long>(triangles.size());
    const std::size_t components = CountComponents(adjacent);
    if (components != 1 || euler != 2)
    {
      m_Violations.push_back("the link of vertex " + std::to_string(v) + " is not one sphere: Euler characteristic " +
                             std::to_string(euler) + ", components " + std::to_string(components));
    }
  }

  /** The complex must be one piece, which the links do not show: they are spheres in each of several pieces, too. */
  void
  CheckConnected()
  {
    Adjacency adjacent;
    for (const auto & [edge, degree] : m_Degrees)
    {
      adjacent[edge[0]].insert(edge[1]);
      adjacent[edge[1]].insert(edge[0]);
    }
    const std::size_t components = CountComponents(adjacent);
    if (components > 1)
    {
      m_Violations.push_back("the complex is not one piece: it has " + std::to_string(components));
    }
  }

  const AdjacencyComplex &               m_Complex;
  std::vector<std::vector<VertexTriple>> m_Star; // The triangles of each vertex's link.
  std::map<VertexTriple, int>            m_Triangles;
  std::map<VertexPair, std::int32_t>     m_Degrees;
  std::set<VertexQuadruple>              m_Keys;
  std::vector<std::string>               m_Violations;
};
} // namespace

std::vector<std::string>
FindViolations(const AdjacencyComplex & complex)
{
  return Check(complex).Run();
}
} // namespace tissue
