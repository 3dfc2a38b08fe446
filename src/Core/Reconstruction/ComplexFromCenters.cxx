/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/DelaunayTetrahedralization.h"
#include "Complex/LocalSpacing.h"
#include "Dual/CellCorners.h"
#include "Optimization/TopologyOptimizer.h"
#include "Reconstruction/TissueComplex.h"
#include "TissueTessellationCore/Common/Stopwatch.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
/** What the Delaunay tetrahedralization takes of the time, for the progress. */
constexpr double DelaunayShare = 0.25;

/** The tetrahedra over vertices by other ids: ids[v] for v. */
std::vector<VertexQuadruple>
Renumbered(std::vector<VertexQuadruple> tetrahedra, const std::vector<VertexId> & ids)
{
  for (VertexQuadruple & tetrahedron : tetrahedra)
  {
    for (VertexId & v : tetrahedron)
    {
      v = ids[v];
    }
    tetrahedron = Canonical(tetrahedron);
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

/** How the Delaunay complex is to be cleaned. */
SurfaceCleanUpParameters
MakeCleanUp(const JunctionSet & junctions, const ReconstructionParameters & parameters,
            const AdjacencyComplex & complex, const std::vector<Point> & centers)
{
  SurfaceCleanUpParameters cleanUp;
  cleanUp.maximumEdgeLength = parameters.maximumEdgeLength;
  if (!(parameters.maximumEdgeLength > 0.0))
  {
    const double median = parameters.localMaximumEdgeLength ? 0.0 : MedianNeighborDistance(junctions);
    cleanUp.maximumEdgeLength = parameters.maximumEdgeLengthFactor * (median > 0.0 ? median : 1.0);
    cleanUp.localLengths = median > 0.0 ? std::vector<double>() : LocalSpacings(complex, centers);
  }
  return cleanUp;
}

/** The dual with its corners by the parameters' rule. */
ImageDual
DualizeSimplicial(const AdjacencyComplex & complex, const JunctionSet & junctions, CornerRule rule)
{
  ImageDual dual{ Dualize(complex, ComputeCorners(complex, junctions, rule)), {} };
  for (const VertexQuadruple & cells : dual.mesh.cellsOfCorner)
  {
    dual.isInImage.push_back(FindJunction(junctions, cells) != nullptr);
  }
  return dual;
}
} // namespace

TissueComplex
MakeComplexFromCenters(const TissueCells & cells, const ReconstructionParameters & parameters,
                       TissueReconstruction & result, const Execution & execution)
{
  Stopwatch stopwatch;
  // The vertices are renumbered by their ranks on the way in, and back on the way out: on large tissues much of the
  // time would else go to fetching what lies far apart.
  std::vector<Point> centers;
  for (const VertexId v : cells.order)
  {
    centers.push_back(cells.centers[v]);
  }
  const ReferenceAdjacency reference = cells.reference.Renumbered(cells.ranks);
  TissueComplex            made;
  const auto               addStage = [&](const std::string & name, const AdjacencyComplex & complex) {
    const double seconds = stopwatch.Lap().wallSeconds;
    result.tetrahedra = Renumbered(complex.GetTetrahedra(), cells.order);
    made.tuples = AdjacencyTuples::Of(result.tetrahedra);
    result.stages.push_back(MakeStage(name, seconds, result.tetrahedra, made.tuples, cells, parameters));
    stopwatch.Lap();
  };
  const auto       numberOfVertices = static_cast<VertexId>(centers.size());
  AdjacencyComplex complex(numberOfVertices, DelaunayTetrahedralization(centers));
  addStage("delaunay", complex);
  execution.Report(DelaunayShare);

  const SurfaceCleanUpParameters cleanUp = MakeCleanUp(cells.junctions, parameters, complex, centers);
  result.maximumEdgeLength =
    cleanUp.maximumEdgeLength * (cleanUp.localLengths.empty() ? 1.0 : MedianSpacing(cleanUp.localLengths));
  result.cleanUp = CleanSurface(complex, centers, cleanUp);
  addStage("cleaned", complex);

  TopologyOptimizer optimizer(complex, centers, &reference, parameters.energy, parameters.annealing);
  result.cycles = optimizer.Run(execution.Part(DelaunayShare, 1.0));
  result.energy = optimizer.Energy();
  addStage("optimized", complex);

  made.dual =
    DualizeSimplicial(AdjacencyComplex(numberOfVertices, result.tetrahedra), cells.junctions, parameters.corners);
  made.cellOf.resize(centers.size());
  std::iota(made.cellOf.begin(), made.cellOf.end(), ExteriorVertex);
  return made;
}
} // namespace tissue
