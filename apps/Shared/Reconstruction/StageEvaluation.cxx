/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/StageEvaluation.h"

#include "Shared/Reconstruction/LabelImageInput.h"
#include "TissueTessellationCore/Image/LabelVolume.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace tissue
{
namespace
{
/** Which cell of the judge the cells of a tissue are. */
struct Counterparts
{
  /** Of each vertex of the tissue the cell of the judge that its centre is in, negative where there is none or another
   * vertex has it; the exterior is the exterior. */
  std::vector<VertexId> cellOfVertex;
  std::size_t           numberOfUnknownCells = 0;
  std::size_t           numberOfMissedCells = 0;
};

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

Counterparts
FindCounterparts(const std::vector<Cell> & cells, const TissueInput & judge, bool isByLabel)
{
  const std::vector<Cell> & judgeCells = judge.GetJunctionSet().cells;
  std::map<Label, VertexId> cellOfLabel;
  for (std::size_t v = 1; v < judgeCells.size(); ++v)
  {
    cellOfLabel[judgeCells[v].label] = static_cast<VertexId>(v);
  }
  Counterparts counterparts;
  counterparts.cellOfVertex.assign(cells.size(), -1);
  counterparts.cellOfVertex[ExteriorVertex] = ExteriorVertex;
  std::set<VertexId> taken{ ExteriorVertex };
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    const auto     found = cellOfLabel.find(cells[v].label);
    const VertexId ofLabel = found != cellOfLabel.end() ? found->second : ExteriorVertex;
    const VertexId cell = isByLabel ? ofLabel : CellAt(judge.extracted.volume->GetLabelVolume(), cells[v].center);
    if (taken.insert(cell).second)
    {
      counterparts.cellOfVertex[v] = cell;
    }
    else
    {
      ++counterparts.numberOfUnknownCells;
    }
  }
  counterparts.numberOfMissedCells = judgeCells.size() - taken.size();
  return counterparts;
}
} // namespace

void
AddEvaluationOptions(CLI::App & app, EvaluationOptions & options)
{
  app
    .add_option(
      "--evaluateAgainst", options.against, "Label image that judges every stage of the complex, in the report")
    ->type_name("FILE")
    ->group("Further outputs");
  app
    .add_flag("--evaluateByLabel",
              options.byLabel,
              "Its cells are those of the same labels; otherwise those that hold the cells' centres")
    ->needs("--evaluateAgainst")
    ->group("Further outputs");
}

std::optional<StageEvaluation>
EvaluateStages(const EvaluationOptions & options, const TissueInput & input,
               const TissueReconstruction & reconstruction, ProgressBar & progress)
{
  if (options.against.empty())
  {
    return std::nullopt;
  }
  LabelImageOptions imageOptions;
  imageOptions.file = options.against;
  imageOptions.input = options.image;
  JunctionOptions junctionOptions;
  junctionOptions.makesVolume = true;
  const TissueInput judge = ExtractTissue(ReadLabelImage(imageOptions, progress), junctionOptions, progress);
  // Cells of the judge itself are known by their labels.
  std::error_code isOther;
  const bool      isItself =
    input.file == options.against || std::filesystem::equivalent(input.file, options.against, isOther);
  const Counterparts counterparts = FindCounterparts(input.GetJunctionSet().cells, judge, isItself || options.byLabel);
  StageEvaluation    evaluation{
    options.against, counterparts.numberOfUnknownCells, counterparts.numberOfMissedCells, {}, {}
  };
  for (const std::string & warning : isItself ? std::vector<std::string>() : judge.warnings)
  {
    evaluation.warnings.push_back(options.against + ": " + warning);
  }
  for (const ReconstructionStage & stage : reconstruction.stages)
  {
    evaluation.stages.push_back(
      ComputeAdjacencyOverlap(stage.tuples, counterparts.cellOfVertex, judge.GetJunctionSet()));
  }
  return evaluation;
}
} // namespace tissue
