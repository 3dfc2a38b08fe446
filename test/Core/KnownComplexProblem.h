/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef KnownComplexProblem_h
#define KnownComplexProblem_h

#include "Complex/ComplexValidity.h"
#include "Adjacency/ReferenceAdjacency.h"
#include "RandomMoves.h"
#include "TestComplexes.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Optimization/OptimizationParameters.h"

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
    return ComputeAdjacencyOverlap(AdjacencyTuples::Of(complex.GetTetrahedra()), reference).adjacency4;
  }

  std::vector<Point>           centers;
  AdjacencyComplex             complex;
  std::vector<VertexQuadruple> truth;
  ReferenceAdjacency           reference;
};
} // namespace tissue_test

#endif
