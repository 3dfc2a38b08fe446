/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/GeneralValidity.h"

#include "Nerve/VertexLinks.h"

namespace tissue
{
namespace
{
std::string
Text(const VertexQuadruple & t)
{
  return "(" + std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " + std::to_string(t[2]) + ", " +
         std::to_string(t[3]) + ")";
}

/** What is wrong with the gluing of a triangle; empty where nothing is. */
std::string
CheckGluing(const GeneralComplex & complex, TetrahedronId id, int i)
{
  const auto &        t = complex.GetTetrahedron(id);
  const TetrahedronId neighbor = t.neighbors[i];
  if (neighbor < 0 || neighbor >= complex.TetrahedronIdBound() || !complex.IsAlive(neighbor))
  {
    return "tetrahedron " + Text(t.vertices) + " has no neighbour " + std::to_string(i);
  }
  const auto &      other = complex.GetTetrahedron(neighbor);
  const std::string both = "neighbours " + Text(t.vertices) + " and " + Text(other.vertices);
  for (int j = 0; j < 4; ++j)
  {
    const int k = LocalIndex(t.vertices, other.vertices[j]);
    if (k >= 0 && k != i)
    {
      continue;
    }
    if (!GeneralComplex::AreGluable(t.vertices, i, other.vertices, j))
    {
      return both + " have different triangles or are not oriented alike";
    }
    if (other.neighbors[j] != id)
    {
      return both + " are not symmetric";
    }
    return other.lines[j] == t.lines[i] ? "" : both + " have different lines";
  }
  return both + " have not one vertex that is not the other's";
}

void
CheckTetrahedra(const GeneralComplex & complex, std::vector<std::string> & violations)
{
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    for (int i = 0; complex.IsAlive(id) && i < 4; ++i)
    {
      const VertexQuadruple & vertices = complex.GetTetrahedron(id).vertices;
      if (LocalIndex(vertices, vertices[i]) != i)
      {
        violations.push_back("tetrahedron " + Text(vertices) + " has a vertex twice");
      }
      std::string violation = CheckGluing(complex, id, i);
      if (!violation.empty())
      {
        violations.push_back(std::move(violation));
      }
    }
  }
}

void
CheckLinks(const GeneralComplex & complex, std::vector<std::string> & violations)
{
  const VertexLinks links = FindVertexLinks(complex);
  for (VertexId v = 0; v < complex.NumberOfVertices(); ++v)
  {
    const std::size_t components = links.NumberOfLinks(v);
    const std::string vertex = "vertex " + std::to_string(v);
    if (components == 0)
    {
      violations.push_back(vertex + " is in no tetrahedron");
    }
    else if (!complex.IsOutside(v) && components > 1)
    {
      violations.push_back("the link of " + vertex + " is split into " + std::to_string(components) + " surfaces");
    }
    else if (!complex.IsOutside(v) && links.links[links.firstOfVertex[v]].eulerCharacteristic != 2)
    {
      violations.push_back("the link of " + vertex + " is no sphere: its Euler characteristic is " +
                           std::to_string(links.links[links.firstOfVertex[v]].eulerCharacteristic));
    }
  }
}
} // namespace

std::vector<std::string>
FindViolations(const GeneralComplex & complex)
{
  std::vector<std::string> violations;
  CheckTetrahedra(complex, violations);
  // Links are walked through the gluings, so these must be in order.
  if (violations.empty())
  {
    CheckLinks(complex, violations);
  }
  return violations;
}
} // namespace tissue
