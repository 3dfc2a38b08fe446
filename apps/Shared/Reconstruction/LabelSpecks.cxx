/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/LabelSpecks.h"

#include <cstdint>

namespace tissue
{
void
RequireFewPieces(const JunctionSet & junctions)
{
  constexpr std::size_t  fewestCells = 8;
  constexpr std::int32_t manyPieces = 8;
  const std::size_t      numberOfCells = junctions.cells.size() - 1;
  const auto             isInPieces = [](const Cell & cell) { return cell.numberOfPieces >= manyPieces; };
  const auto             numberInPieces =
    static_cast<std::size_t>(std::count_if(junctions.cells.begin() + 1, junctions.cells.end(), isInPieces));
  if (numberOfCells >= fewestCells && 2 * numberInPieces > numberOfCells)
  {
    throw std::runtime_error(
      std::to_string(numberInPieces) + " of " + std::to_string(numberOfCells) + " labels are in " +
      std::to_string(manyPieces) +
      " pieces or more: this is no label image of cells; for an image of membranes there is "
      "TissueTessellation --membrane, for one of nuclei NucleiTessellation; --acceptSpecks takes "
      "it for labels all the same");
  }
}
} // namespace tissue
