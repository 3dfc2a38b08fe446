/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Complex/AdjacencyComplex.h"
#include "Nerve/ImageTopology.h"
#include "Reconstruction/TissueComplex.h"
#include "TissueTessellationCore/Common/Stopwatch.h"

#include <algorithm>
#include <limits>
#include <map>

namespace tissue
{
namespace
{
/** The tetrahedra of four different cells, as AdjacencyComplex::GetTetrahedra() has them. */
std::vector<VertexQuadruple>
TetrahedraOfCells(const GeneralComplex & complex, const std::vector<VertexId> & cellOf)
{
  std::vector<VertexQuadruple> tetrahedra;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id))
    {
      const VertexQuadruple cells = CellsOf(complex.GetTetrahedron(id).vertices, cellOf);
      if (AreDifferent(cells))
      {
        tetrahedra.push_back(Canonical(cells));
      }
    }
  }
  std::sort(tetrahedra.begin(), tetrahedra.end());
  return tetrahedra;
}

/** The pairs of different cells that an edge joins. */
std::vector<VertexPair>
PairsOfCells(const GeneralComplex & complex, const std::vector<VertexId> & cellOf)
{
  std::vector<VertexPair> pairs;
  for (const GeneralComplex::Edge & edge : complex.FindEdges())
  {
    const VertexPair cells{ { cellOf[edge.vertices[0]], cellOf[edge.vertices[1]] } };
    if (cells[0] != cells[1])
    {
      pairs.push_back(cells);
    }
  }
  return pairs;
}

PlacePreferences
ChoosePreferences(const ReconstructionParameters & parameters, const JunctionSet & junctions)
{
  if (!junctions.votes.empty())
  {
    return PlacePreferences::ByVotes();
  }
  return parameters.preference == AdjacencyPreference::Walls ? PlacePreferences::WallsFirst()
                                                             : PlacePreferences::JunctionsFirst();
}

/** What the user should know of how the complex was taken from the image. */
void
AddRemarks(const ImageTopology & topology, std::vector<CellRemark> & remarks)
{
  for (const Fragment & fragment : topology.fragments.fragments)
  {
    if (fragment.cell != ExteriorVertex)
    {
      remarks.push_back({ fragment.cell,
                          fragment.isLarge ? Remark::Fragment : Remark::FragmentDropped,
                          static_cast<double>(fragment.numberOfVoxels) });
    }
  }
  for (const DividedCell & divided : topology.divided)
  {
    const VertexId cell = topology.cellOf[divided.cell];
    if (cell != ExteriorVertex)
    {
      remarks.push_back({ cell, Remark::RingWalls, static_cast<double>(divided.numberOfPieces) });
    }
  }
  for (const HandleCut & cut : topology.handles)
  {
    if (cut.numberOfVoxels > 0)
    {
      remarks.push_back({ topology.cellOf[cut.cell], Remark::HandlesCut, static_cast<double>(cut.numberOfVoxels) });
    }
    if (cut.handlesLeft > 0)
    {
      remarks.push_back({ topology.cellOf[cut.cell], Remark::HandlesKept, static_cast<double>(cut.handlesLeft) });
    }
  }
  std::map<VertexId, int> repairsOf;
  for (const NerveRepairRecord & repair : topology.repairs)
  {
    ++repairsOf[topology.cellOf[repair.vertex]];
  }
  for (const auto & [cell, count] : repairsOf)
  {
    if (cell != ExteriorVertex)
    {
      remarks.push_back({ cell, Remark::Repaired, static_cast<double>(count) });
    }
  }
}
} // namespace

TissueComplex
TakeComplexFromImage(const TissueCells & cells, const LabelVolume & volume, const ReconstructionParameters & parameters,
                     TissueReconstruction & result, const Execution & execution)
{
  Stopwatch               stopwatch;
  ImageTopologyParameters topologyParameters;
  topologyParameters.preferences = ChoosePreferences(parameters, cells.junctions);
  topologyParameters.votes = cells.junctions.votes;
  topologyParameters.descends = FindSpecks(cells.junctions.cells).empty();
  if (!cells.junctions.votes.empty())
  {
    // Fragments of estimated cells mean nothing.
    topologyParameters.minimumFragmentVoxels = std::numeric_limits<std::int64_t>::max();
  }
  TissueComplex complex;
  const auto    makeStage = [&](const std::string & name, const ImageTopology & topology) {
    const double seconds = stopwatch.Lap().wallSeconds;
    result.tetrahedra = TetrahedraOfCells(topology.nerve.complex, topology.cellOf);
    complex.tuples = AdjacencyTuples::Of(result.tetrahedra, PairsOfCells(topology.nerve.complex, topology.cellOf));
    ReconstructionStage stage = MakeStage(name, seconds, result.tetrahedra, complex.tuples, cells, parameters);
    stopwatch.Lap();
    return stage;
  };
  ImageTopology topology =
    FindImageTopology(volume,
                      static_cast<VertexId>(cells.junctions.cells.size()),
                      topologyParameters,
                      execution,
                      [&](const ImageTopology & nerve) { result.stages = { makeStage("nerve", nerve) }; });
  result.stages.push_back(makeStage("optimized", topology));
  result.energy = topology.descent.energyAfter;
  AddRemarks(topology, result.remarks);
  complex.dual = DualizeNerve(topology.nerve, topology.places.corners, topology.cellOf, cells.centers);
  complex.cellOf = std::move(topology.cellOf);
  complex.volume = std::move(topology.volume);
  return complex;
}
} // namespace tissue
