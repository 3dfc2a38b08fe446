/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_AnnealingState_h
#define TissueTessellationCore_AnnealingState_h

#include "TissueTessellationCore/EnergyFunction.h"
#include "TissueTessellationCore/LocalOperations.h"
#include "TissueTessellationCore/Random.h"

#include <cmath>

namespace tissue
{
/** \brief A complex under annealing, with what every schedule needs: the operations, the energy, chance. */
struct AnnealingState
{
  AdjacencyComplex & complex;
  LocalOperations    operations;
  EnergyFunction     energy;
  Random             random;

  /** The Metropolis rule: carries out a legal proposal where it lowers the energy, else with probability
   * exp(-difference / temperature). Returns whether it did. */
  bool
  Try(const Proposal & proposal, double temperature)
  {
    if (!proposal)
    {
      return false;
    }
    const double difference = energy.Difference(proposal.replacement);
    if (difference > 0.0 && random.Uniform() >= std::exp(-difference / temperature))
    {
      return false;
    }
    energy.Update(proposal.replacement);
    complex.Apply(proposal.replacement);
    return true;
  }

  /** The vertex on the other side of triangle i of a tetrahedron. */
  VertexId
  VertexBehind(TetrahedronId id, int i) const
  {
    return complex.GetTetrahedron(complex.GetTetrahedron(id).neighbors[i]).vertices[complex.MirrorIndex(id, i)];
  }

  /** Edge removal with the ring's triangulation that makes most quadruples of the reference. */
  Proposal
  RemoveEdgeByReference(VertexPair edge) const
  {
    const ReferenceAdjacency & reference = *energy.GetReference();
    return operations.RemoveEdge(edge, [&](VertexPair e, const AdjacencyComplex::Ring & ring, int i, int j, int k) {
      const VertexId a = ring.vertices[i];
      const VertexId b = ring.vertices[j];
      const VertexId c = ring.vertices[k];
      return -static_cast<double>(reference.HasQuadruple({ { e[0], a, b, c } })) -
             static_cast<double>(reference.HasQuadruple({ { e[1], a, b, c } }));
    });
  }
};
} // namespace tissue

#endif
