/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/VertexLinks.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
constexpr std::int32_t None = -1;

/** Marks all triangles of the component of a link that a tetrahedron's local vertex is the apex of. */
std::int32_t
Flood(const GeneralComplex & complex, TetrahedronId id, int local, std::int32_t component, VertexLinks & links)
{
  std::vector<std::pair<TetrahedronId, int>> open{ { id, local } };
  links.linkOf[id][local] = component;
  std::int32_t count = 0;
  while (!open.empty())
  {
    const auto [t, i] = open.back();
    open.pop_back();
    ++count;
    for (int j = 0; j < 4; ++j)
    {
      if (j == i)
      {
        continue;
      }
      const TetrahedronId other = complex.GetTetrahedron(t).neighbors[j];
      const int           k = LocalIndex(complex.GetTetrahedron(other).vertices, complex.GetTetrahedron(t).vertices[i]);
      if (links.linkOf[other][k] == None)
      {
        links.linkOf[other][k] = component;
        open.emplace_back(other, k);
      }
    }
  }
  return count;
}

/** Brings the components in the promised order. */
void
SortByVertex(VertexLinks & links, VertexId numberOfVertices)
{
  std::vector<std::int32_t> order(links.links.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return links.links[a].vertex < links.links[b].vertex;
  });
  std::vector<VertexLink>   sorted;
  std::vector<std::int32_t> rank(order.size());
  links.firstOfVertex.assign(static_cast<std::size_t>(numberOfVertices) + 1, 0);
  for (const std::int32_t i : order)
  {
    rank[i] = static_cast<std::int32_t>(sorted.size());
    sorted.push_back(links.links[i]);
    ++links.firstOfVertex[links.links[i].vertex + 1];
  }
  std::partial_sum(links.firstOfVertex.begin(), links.firstOfVertex.end(), links.firstOfVertex.begin());
  links.links = std::move(sorted);
  for (auto & ofTetrahedron : links.linkOf)
  {
    for (std::int32_t & link : ofTetrahedron)
    {
      link = link == None ? None : rank[link];
    }
  }
}
} // namespace

VertexLinks
FindVertexLinks(const GeneralComplex & complex)
{
  VertexLinks links;
  links.linkOf.assign(static_cast<std::size_t>(complex.TetrahedronIdBound()), { { None, None, None, None } });
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; complex.IsAlive(id) && i < 4; ++i)
    {
      if (links.linkOf[id][i] == None)
      {
        const auto         component = static_cast<std::int32_t>(links.links.size());
        const std::int32_t triangles = Flood(complex, id, i, component, links);
        // A closed surface of F triangles has 3 F / 2 edges: F - E = -F / 2. Its vertices follow.
        links.links.push_back({ complex.GetTetrahedron(id).vertices[i], triangles, -triangles / 2, id });
      }
    }
  }
  SortByVertex(links, complex.NumberOfVertices());
  // Each edge of the complex is one vertex in the link of each of its two ends.
  for (const GeneralComplex::Edge & edge : complex.FindEdges())
  {
    ++links.links[links.linkOf[edge.local.tetrahedron][edge.local.from]].eulerCharacteristic;
    ++links.links[links.linkOf[edge.local.tetrahedron][edge.local.to]].eulerCharacteristic;
  }
  return links;
}
} // namespace tissue
