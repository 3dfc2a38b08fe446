/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Adjacency/SuspectCells.h"

#include <algorithm>
#include <optional>

namespace tissue
{
namespace
{
/** The areas of the voxel faces of a cell. */
struct CellArea
{
  double all = 0.0;
  double toExterior = 0.0;
};

std::vector<CellArea>
SumAreas(const JunctionSet & junctions)
{
  std::vector<CellArea> areas(junctions.cells.size());
  for (const Wall & wall : junctions.walls)
  {
    for (const VertexId cell : wall.cells)
    {
      areas[cell].all += wall.area;
      areas[cell].toExterior += wall.cells[0] == ExteriorVertex ? wall.area : 0.0;
    }
  }
  return areas;
}

double
MedianVolume(const std::vector<Cell> & cells)
{
  std::vector<double> volumes;
  std::transform(
    cells.begin() + 1, cells.end(), std::back_inserter(volumes), [](const Cell & cell) { return cell.volume; });
  const auto median = volumes.begin() + static_cast<std::ptrdiff_t>(volumes.size() / 2);
  std::nth_element(volumes.begin(), median, volumes.end());
  return *median;
}

/** 1 for a ball, of which the faces of voxels have half more area than its surface. */
double
Compactness(double volume, double areaOfFaces)
{
  constexpr double ofBall = 113.09733552923255; // 36 pi
  const double     area = areaOfFaces / 1.5;
  return ofBall * volume * volume / (area * area * area);
}

/** \param volume over the median one. */
std::optional<SuspectCell>
Suspect(VertexId v, const Cell & cell, const CellArea & area, double volume)
{
  constexpr double large = 8.0;
  constexpr double largest = 32.0;
  constexpr double leastCompactness = 0.4;
  constexpr double largePocket = 4.0;
  constexpr double shareOfPocket = 0.6;
  constexpr double shareOfPieces = 0.1;
  if (cell.touchesBorder)
  {
    const bool isCompact = Compactness(cell.volume, area.all) >= leastCompactness;
    if (volume > largest || (volume > large && !isCompact))
    {
      return SuspectCell{ v, Suspicion::Large, volume };
    }
    if (volume > largePocket && area.toExterior >= shareOfPocket * area.all)
    {
      return SuspectCell{ v, Suspicion::Pocket, volume };
    }
    return std::nullopt;
  }
  const double share = static_cast<double>(cell.numberOfStrayVoxels) / static_cast<double>(cell.numberOfVoxels);
  return share > shareOfPieces ? std::optional<SuspectCell>({ v, Suspicion::Pieces, share }) : std::nullopt;
}
} // namespace

std::vector<SuspectCell>
FindSuspectCells(const JunctionSet & junctions)
{
  constexpr std::size_t    fewest = 8;
  std::vector<SuspectCell> suspects;
  if (junctions.cells.size() < fewest + 1 || junctions.walls.empty())
  {
    return suspects;
  }
  const double                median = MedianVolume(junctions.cells);
  const std::vector<CellArea> areas = SumAreas(junctions);
  for (std::size_t v = 1; v < junctions.cells.size(); ++v)
  {
    const Cell & cell = junctions.cells[v];
    const auto   suspect = Suspect(static_cast<VertexId>(v), cell, areas[v], cell.volume / median);
    if (suspect)
    {
      suspects.push_back(*suspect);
    }
  }
  return suspects;
}
} // namespace tissue
