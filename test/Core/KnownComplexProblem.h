/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef KnownComplexProblem_h
#define KnownComplexProblem_h

#include "Complex/ComplexValidity.h"
#include "Optimization/AnnealingState.h"
#include "RandomMoves.h"
#include "TestComplexes.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"

namespace tissue_test
{
inline EnergyParameters
ImageTermOnly()
{
  EnergyParameters parameters;
  parameters.neighborWeight = 0.0;
  parameters.lengthWeight = 0.0;
  return parameters;
}

/** A random Delaunay complex as the truth, what an image of it would give, and a scrambled start. */
struct Problem
{
  Problem(int numberOfCells, int numberOfMoves, std::uint64_t seed, Legality legality = Legality::Combinatorial)
    : centers(RandomCenters(numberOfCells, seed))
    , complex(DelaunayComplex(centers))
    , truth(complex.GetTetrahedra())
    , reference(JunctionsOf(complex, centers))
  {
    Random random(seed);
    Scramble(complex, LocalOperations(complex, centers, legality), numberOfMoves, random);
  }

  double
  Adjacency4() const
  {
    return ComputeAdjacencyOverlap(complex, reference).adjacency4;
  }

  /** The energy of one quadruple. */
  double
  OneQuadruple() const
  {
    return ImageTermOnly().adjacencyWeight / static_cast<double>(reference.NumberOfQuadruples());
  }

  AnnealingState
  MakeState(std::uint64_t seed = 1)
  {
    return { complex,
             LocalOperations(complex, centers, Legality::Combinatorial),
             EnergyFunction(complex, centers, &reference, ImageTermOnly()),
             Random(seed) };
  }

  std::vector<Point>           centers;
  AdjacencyComplex             complex;
  std::vector<VertexQuadruple> truth;
  ReferenceAdjacency           reference;
};
} // namespace tissue_test

#endif
