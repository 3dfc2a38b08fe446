/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TestGeneralComplexes_h
#define TissueTessellationCore_TestGeneralComplexes_h

#include "Nerve/GeneralMoves.h"
#include "Nerve/GeneralValidity.h"
#include "Nerve/VertexLinks.h"

#include <algorithm>
#include <map>
#include <sstream>

/** Small general complexes and ways to compare them. */
namespace testing_nerve
{
using namespace tissue;

/** The simplicial complex of positively oriented tetrahedra: each triangle is glued to the other one of its vertices,
 * the lines numbered as they come, the corners as the tetrahedra. */
inline GeneralComplex
Simplicial(VertexId numberOfVertices, const std::vector<VertexQuadruple> & tetrahedra)
{
  GeneralComplex               complex(numberOfVertices);
  std::map<VertexTriple, Side> open;
  LineId                       line = 0;
  for (const VertexQuadruple & t : tetrahedra)
  {
    const TetrahedronId id = complex.Add(t, complex.TetrahedronIdBound());
    for (int i = 0; i < 4; ++i)
    {
      VertexTriple triangle{ { t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4] } };
      std::sort(triangle.begin(), triangle.end());
      const auto found = open.emplace(triangle, Side{ id, i });
      if (!found.second)
      {
        complex.Glue(found.first->second, { id, i }, line++);
      }
    }
  }
  return complex;
}

/** The boundary of a simplex of five vertices: the smallest simplicial 3-sphere. */
inline GeneralComplex
FiveCells()
{
  return Simplicial(
    5, { { { 1, 2, 3, 4 } }, { { 0, 3, 2, 4 } }, { { 0, 1, 3, 4 } }, { { 0, 2, 1, 4 } }, { { 0, 1, 2, 3 } } });
}

/** Two tetrahedra glued along all their triangles: a 3-sphere that is not simplicial. */
inline GeneralComplex
FourCells(VertexId numberOfVertices = 4)
{
  GeneralComplex complex(numberOfVertices);
  complex.Add({ { 0, 1, 2, 3 } });
  complex.Add({ { 1, 0, 2, 3 } });
  for (int i = 0; i < 4; ++i)
  {
    complex.Glue({ 0, i }, { 1, i == 0 ? 1 : i == 1 ? 0 : i }, i);
  }
  return complex;
}

/** The Euler characteristics of the components of the link of each vertex, ascending. */
inline std::vector<std::vector<std::int32_t>>
EulerCharacteristics(const GeneralComplex & complex)
{
  std::vector<std::vector<std::int32_t>> all(static_cast<std::size_t>(complex.NumberOfVertices()));
  for (const VertexLink & link : FindVertexLinks(complex).links)
  {
    all[link.vertex].push_back(link.eulerCharacteristic);
  }
  for (auto & ofVertex : all)
  {
    std::sort(ofVertex.begin(), ofVertex.end());
  }
  return all;
}

/** Everything that a complex holds. */
inline std::string
Dump(const GeneralComplex & complex)
{
  std::ostringstream text;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      const auto & t = complex.GetTetrahedron(id);
      text << id << ':';
      for (int i = 0; i < 4; ++i)
      {
        text << ' ' << t.vertices[i] << ' ' << t.neighbors[i] << ' ' << t.lines[i];
      }
      text << " corner " << t.corner << '\n';
    }
  }
  return text.str();
}

/** How many edges join each two vertices. */
inline std::map<VertexPair, int>
CountEdges(const GeneralComplex & complex)
{
  std::map<VertexPair, int> count;
  for (const auto & edge : complex.FindEdges())
  {
    ++count[edge.vertices];
  }
  return count;
}
} // namespace testing_nerve

#endif
