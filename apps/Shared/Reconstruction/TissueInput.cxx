/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/TissueInput.h"

#include "Shared/Reconstruction/SuspectLabels.h"
#include "TissueTessellationCore/Adjacency/SeparatedCells.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
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

std::vector<std::string>
CheckExterior(const JunctionSet & junctions)
{
  if (junctions.cells[ExteriorVertex].numberOfVoxels > 0)
  {
    return {};
  }
  // All that is at the exterior is at the border of the image.
  double           border = 0.0;
  const Wall *     largest = nullptr;
  constexpr double manyPercent = 12.5;
  for (const Wall & wall : junctions.walls)
  {
    if (wall.cells[0] == ExteriorVertex)
    {
      border += wall.area;
      largest = largest == nullptr || wall.area > largest->area ? &wall : largest;
    }
  }
  std::ostringstream text;
  text << "no voxel of the image is exterior: the cells fill it, and its outside is the exterior";
  if (largest != nullptr && 100.0 * largest->area >= manyPercent * border)
  {
    text << "; if label " << junctions.cells[largest->cells[1]].label << ", which covers "
         << std::lround(100.0 * largest->area / border) << " % of the image's border, is background, --exteriorLabel "
         << junctions.cells[largest->cells[1]].label << " says so";
  }
  return { text.str() };
}

std::vector<std::string>
CheckSuspects(const JunctionSet & junctions)
{
  const std::vector<Label> labels = FindSuspectLabels(junctions);
  if (labels.empty())
  {
    return {};
  }
  return { std::to_string(labels.size()) + (labels.size() == 1 ? " label may be no cell" : " labels may be no cells") +
           ", by size, place or pieces (" + NameLabels(labels) +
           "); --dropCells suspects takes such labels for exterior, --dropCells LABELS those that you name" };
}

std::vector<std::string>
CheckClosedGaps(const std::optional<ClosedGaps> & closedGaps)
{
  constexpr double mostLeft = 0.05;
  if (!closedGaps || closedGaps->shareLeft < mostLeft)
  {
    return {};
  }
  std::ostringstream text;
  text << "gaps remain between cells, in " << std::lround(100.0 * closedGaps->shareLeft)
       << " % of the places where two are next to each other; --closeGaps=" << std::setprecision(3)
       << std::max(closedGaps->widthLeft, 2.0 * closedGaps->width) << " would close more of them";
  return { text.str() };
}
} // namespace tissue
