/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/TissueInput.h"

#include "TissueTessellationCore/Adjacency/SeparatedCells.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace tissue
{
void
Append(const std::vector<std::string> & more, std::vector<std::string> & warnings)
{
  warnings.insert(warnings.end(), more.begin(), more.end());
}

std::string
NameLabels(const std::vector<Label> & labels)
{
  constexpr std::size_t most = 10;
  std::ostringstream    text;
  for (std::size_t i = 0; i < std::min(labels.size(), most); ++i)
  {
    text << (i > 0 ? ", " : "") << labels[i];
  }
  text << (labels.size() > most ? ", ..." : "");
  return text.str();
}

std::vector<std::string>
CheckThatCellsTouch(const JunctionSet & junctions, const std::optional<ClosedGaps> & closedGaps)
{
  const std::vector<VertexId> separated = FindSeparatedCells(junctions);
  if (separated.empty())
  {
    return {};
  }
  std::vector<Label> labels;
  for (const VertexId cell : separated)
  {
    labels.push_back(junctions.cells[cell].label);
  }
  const std::size_t numberOfCells = junctions.cells.size() - 1;
  const std::string message = std::to_string(separated.size()) + " of " + std::to_string(numberOfCells) +
                              " cells touch no other cell though others are near (labels " + NameLabels(labels) +
                              "): a wall of background lies between them";
  if (2 * separated.size() > numberOfCells)
  {
    std::ostringstream help;
    if (closedGaps)
    {
      help << ", wider than the gaps that --closeGaps has closed, of " << closedGaps->width;
    }
    else
    {
      help << "; --closeGaps grows the labels over such walls";
    }
    throw std::runtime_error(message + help.str());
  }
  return { message };
}
} // namespace tissue
