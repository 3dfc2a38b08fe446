/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_AnnealingState_h
#define TissueTessellationCore_AnnealingState_h

#include "Complex/LocalOperations.h"
#include "Optimization/EnergyFunction.h"
#include "TissueTessellationCore/Common/Random.h"

#include <cmath>

namespace tissue
{
/** Temperatures that fall geometrically from the first to the last of a number of rounds. */
struct Cooling
{
  double first;
  double last;
  int    numberOfRounds;

  double
  Temperature(int round) const
  {
    return numberOfRounds > 1 ? first * std::pow(last / first, static_cast<double>(round) / (numberOfRounds - 1))
                              : first;
  }
};

/** \brief A complex under annealing, with what every schedule needs: the operations on it, its energy, and random
 * numbers. */
struct AnnealingState
{
  AdjacencyComplex & complex;
  LocalOperations    operations;
  EnergyFunction     energy;
  Random             random;

  /** The Metropolis rule: a legal proposal is accepted where it lowers the energy, else with probability
   * exp(-difference / temperature). */
  bool
  Accepts(const Proposal & proposal, double temperature)
  {
    if (!proposal)
    {
      return false;
    }
    const double difference = energy.Difference(proposal.replacement);
    return difference <= 0.0 || random.Uniform() < std::exp(-difference / temperature);
  }

  /** Carries out a replacement and returns its inverse. */
  Replacement
  Do(const Replacement & replacement)
  {
    energy.Update(replacement);
    return complex.Apply(replacement);
  }

  /** Carries out a proposal if it is accepted. Returns whether it was. */
  bool
  Try(const Proposal & proposal, double temperature)
  {
    const bool isAccepted = this->Accepts(proposal, temperature);
    if (isAccepted)
    {
      this->Do(proposal.replacement);
    }
    return isAccepted;
  }

  /** Returns the vertex on the other side of triangle i of a tetrahedron. */
  VertexId
  VertexBehind(TetrahedronId id, int i) const
  {
    return complex.GetTetrahedron(complex.GetTetrahedron(id).neighbors[i]).vertices[complex.MirrorIndex(id, i)];
  }

  /** Returns those of the tetrahedra that are not in the reference, or have less than four fifths of its votes, and
   * their neighbours, ascending. */
  std::vector<TetrahedronId>
  WrongAndNeighbors(const std::vector<TetrahedronId> & tetrahedra) const;

  /** Proposes the removal of an edge with that triangulation of its ring that makes most quadruples of the reference,
   * or those with most votes. */
  Proposal
  RemoveEdgeByReference(VertexPair edge) const;

  /** Proposes a random operation at a tetrahedron: a triangle swap, or the removal of an edge up to a degree, with its
   * ring triangulated by the reference or at random. */
  Proposal
  ProposeAt(TetrahedronId id, std::int32_t maximumDegree);
};
} // namespace tissue

#endif
