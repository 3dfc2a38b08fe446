/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Optimization/EnergyFunction.h"

#include "Complex/LocalSpacing.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tissue
{
EnergyFunction::EnergyFunction(const AdjacencyComplex & complex, const std::vector<Point> & centers,
                               const ReferenceAdjacency * reference, const EnergyParameters & parameters)
  : m_Complex(complex)
  , m_Centers(centers)
  , m_Reference(reference)
  , m_Parameters(parameters)
{
  if (m_Parameters.delaunayWeight != 0.0 || m_Parameters.unitLength == 0.0)
  {
    std::vector<double> spacings = LocalSpacings(complex, centers);
    if (m_Parameters.unitLength == 0.0)
    {
      m_Parameters.unitLength = MedianSpacing(spacings);
    }
    if (m_Parameters.delaunayWeight != 0.0)
    {
      m_DelaunayDeviation.emplace(centers, std::move(spacings));
    }
  }
  this->Recompute();
}

void
EnergyFunction::Recompute()
{
  // Every term of the energy is a function of sums over tetrahedra and cells.
  m_Sums = Sums();
  for (TetrahedronId id = 0; id < m_Complex.TetrahedronIdBound(); ++id)
  {
    if (m_Complex.IsAlive(id))
    {
      AddTetrahedron(m_Complex.GetTetrahedron(id).vertices, +1, m_Sums);
    }
  }
  for (VertexId v = ExteriorVertex + 1; v < m_Complex.NumberOfVertices(); ++v)
  {
    m_Sums.prior += NeighborDeviation(m_Complex.NumberOfNeighbors(v), m_Complex.FindEdge(ExteriorVertex, v) != nullptr);
  }
}

double
EnergyFunction::Evaluate(const Sums & sums) const
{
  double image = 0.0;
  if (m_Reference)
  {
    image = m_Parameters.adjacencyWeight * Jaccard(static_cast<std::size_t>(sums.hits),
                                                   static_cast<std::size_t>(sums.tetrahedra),
                                                   m_Reference->NumberOfQuadruples());
  }
  const auto cells = static_cast<double>(m_Complex.NumberOfVertices() - 1);
  return -image + m_Parameters.neighborWeight * sums.prior / cells +
         m_Parameters.delaunayWeight * sums.delaunayDeviation / cells +
         m_Parameters.lengthWeight * sums.length / (static_cast<double>(sums.tetrahedra) * m_Parameters.unitLength);
}

double
EnergyFunction::LongestEdge(const VertexQuadruple & t) const
{
  double longest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      if (t[i] != ExteriorVertex && t[j] != ExteriorVertex)
      {
        const Point edge = m_Centers[t[j]] - m_Centers[t[i]];
        longest = std::max(longest, Dot(edge, edge));
      }
    }
  }
  return std::sqrt(longest);
}

double
EnergyFunction::NeighborDeviation(std::int32_t numberOfNeighbors, bool touchesExterior) const
{
  const double ideal = touchesExterior ? m_Parameters.epidermalNeighbors + 1.0 : m_Parameters.innerNeighbors;
  const double deviation = numberOfNeighbors - ideal;
  return deviation * deviation;
}

void
EnergyFunction::AddTetrahedron(const VertexQuadruple & vertices, int sign, Sums & sums) const
{
  sums.tetrahedra += sign;
  if (m_Reference && m_Reference->HasQuadruple(vertices))
  {
    sums.hits += sign;
  }
  if (m_Parameters.lengthWeight != 0.0)
  {
    sums.length += sign * LongestEdge(vertices);
  }
  if (m_DelaunayDeviation)
  {
    sums.delaunayDeviation += sign * m_DelaunayDeviation->Of(vertices);
  }
}

EnergyFunction::Sums
EnergyFunction::SumsAfter(const Replacement & replacement) const
{
  // The sums over tetrahedra change by those that go and come.
  Sums sums = m_Sums;
  for (const TetrahedronId id : replacement.removed)
  {
    AddTetrahedron(m_Complex.GetTetrahedron(id).vertices, -1, sums);
  }
  for (const VertexQuadruple & vertices : replacement.created)
  {
    AddTetrahedron(vertices, +1, sums);
  }
  if (m_Parameters.neighborWeight == 0.0)
  {
    return sums;
  }
  // The sum of the prior runs over cells, (n - N)^2 each. It changes at the ends of the edges that go and come, by n
  // and, where such an edge leads to the exterior, by N as well. Each vertex is collected with its whole change first,
  // since the square of a sum is not the sum of squares. Room for 16 of them is enough for an edge of degree 14.
  struct Change
  {
    VertexId     vertex;
    std::int32_t neighbors;
    int          exterior;
  };
  boost::container::small_vector<Change, 16> changes;
  const auto                                 count = [&changes](VertexId vertex, VertexId other, int sign) {
    auto at = std::find_if(changes.begin(), changes.end(), [vertex](const Change & c) { return c.vertex == vertex; });
    if (at == changes.end())
    {
      changes.push_back({ vertex, 0, 0 });
      at = changes.end() - 1;
    }
    at->neighbors += sign;
    at->exterior += other == ExteriorVertex ? sign : 0;
  };
  for (const VertexPair & edge : replacement.removedEdges)
  {
    count(edge[0], edge[1], -1);
    count(edge[1], edge[0], -1);
  }
  for (const VertexPair & edge : replacement.createdEdges)
  {
    count(edge[0], edge[1], +1);
    count(edge[1], edge[0], +1);
  }
  for (const Change & change : changes)
  {
    if (change.vertex != ExteriorVertex)
    {
      const std::int32_t before = m_Complex.NumberOfNeighbors(change.vertex);
      const bool         touched = m_Complex.FindEdge(ExteriorVertex, change.vertex) != nullptr;
      const bool         touches = (touched ? 1 : 0) + change.exterior > 0;
      sums.prior += NeighborDeviation(before + change.neighbors, touches) - NeighborDeviation(before, touched);
    }
  }
  return sums;
}
} // namespace tissue
