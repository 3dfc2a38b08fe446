/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/StageEvaluation.h"

#include "Shared/CommandLine/RunProgram.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace tissue
{
namespace
{
/** The judge's cell at a place, or the exterior. */
VertexId
CellAt(const LabelVolume & volume, const Point & position)
{
  const Point index = volume.ToIndex(position);
  const auto  round = [](double value) {
    return static_cast<std::int32_t>(std::floor(std::clamp(value, -1e9, 1e9) + 0.5));
  };
  return volume.At(round(index[0]), round(index[1]), round(index[2]));
}
} // namespace

Judge
ReadJudge(const std::string & path, const std::vector<Cell> & cells, bool isByLabel, ProgressBar & progress)
{
  ReconstructionOptions options;
  options.labels = path;
  options.parameters.separateVoids = false;
  const TissueInput input = WithFileName(path, [&] { return ReadTissue(options, progress); });
  Judge             judge;
  judge.junctions = input.junctions->GetJunctionSet();
  std::map<Label, VertexId> cellOfLabel;
  for (std::size_t v = 1; v < judge.junctions.cells.size(); ++v)
  {
    cellOfLabel[judge.junctions.cells[v].label] = static_cast<VertexId>(v);
  }
  judge.cellOfVertex.assign(cells.size(), -1);
  judge.cellOfVertex[ExteriorVertex] = ExteriorVertex;
  std::set<VertexId> taken{ ExteriorVertex };
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    const auto     found = cellOfLabel.find(cells[v].label);
    const VertexId ofLabel = found != cellOfLabel.end() ? found->second : ExteriorVertex;
    const VertexId cell = isByLabel ? ofLabel : CellAt(input.volume->GetLabelVolume(), cells[v].center);
    if (taken.insert(cell).second)
    {
      judge.cellOfVertex[v] = cell;
    }
    else
    {
      ++judge.numberOfUnknownCells;
    }
  }
  judge.numberOfMissedCells = judge.junctions.cells.size() - taken.size();
  return judge;
}

StageEvaluation
EvaluateStages(const TissueReconstruction & reconstruction, const Judge & judge)
{
  const auto evaluate = [&](const std::vector<VertexQuadruple> & tetrahedra) {
    return ComputeAdjacencyOverlap(tetrahedra, judge.cellOfVertex, judge.junctions);
  };
  return { evaluate(reconstruction.delaunay.tetrahedra),
           evaluate(reconstruction.cleaned.tetrahedra),
           evaluate(reconstruction.tetrahedra) };
}
} // namespace tissue
