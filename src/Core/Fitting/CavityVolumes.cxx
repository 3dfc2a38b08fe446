/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/CavityVolumes.h"

#include "Image/ImageVoids.h"
#include "Mesh/Cavities.h"

#include <algorithm>

namespace tissue
{
namespace
{
bool
IsWithin(const Point & p, const Box & box, double margin)
{
  for (int i = 0; i < 3; ++i)
  {
    if (p[i] < box.lower[i] - margin || p[i] > box.upper[i] + margin)
    {
      return false;
    }
  }
  return true;
}

/** The number of the cavity that a void in a cell is, or of all of them. \param cavities by their cells. */
std::size_t
FindCavityAt(const std::vector<Cavity> & cavities, VertexId cell, const Point & place, double margin)
{
  std::size_t found = cavities.size();
  const auto  begin = std::lower_bound(
    cavities.begin(), cavities.end(), cell, [](const Cavity & cavity, VertexId other) { return cavity.cell < other; });
  for (auto at = begin; at != cavities.end() && at->cell == cell; ++at)
  {
    const bool isSmaller = found == cavities.size() || at->volume < cavities[found].volume;
    if (isSmaller && IsWithin(place, at->box, margin))
    {
      found = static_cast<std::size_t>(at - cavities.begin());
    }
  }
  return found;
}
} // namespace

CavityVolumes
FindCavityVolumes(const WallMesh & mesh, std::size_t numberOfVertices, const LabelVolume & cells)
{
  std::vector<Cavity> cavities = FindCavities(mesh);
  std::stable_sort(
    cavities.begin(), cavities.end(), [](const Cavity & a, const Cavity & b) { return a.cell < b.cell; });
  CavityVolumes result;
  result.volumes.assign(cavities.size(), 0.0);
  result.ofWall.assign(mesh.walls.size(), ExteriorVertex);
  for (std::size_t c = 0; c < cavities.size(); ++c)
  {
    for (const WallId wall : cavities[c].walls)
    {
      result.ofWall[wall] = static_cast<VertexId>(numberOfVertices + c);
    }
  }
  const double length = cells.VoxelLength();
  for (const ImageVoid & hole : FindVoidsInCells(cells))
  {
    Point index;
    std::copy(hole.first.begin(), hole.first.end(), index.begin());
    const std::size_t cavity = FindCavityAt(cavities, hole.cell, cells.ToPhysical(index), length);
    if (cavity < cavities.size())
    {
      result.volumes[cavity] += static_cast<double>(hole.voxels) * length * length * length;
    }
    else
    {
      result.cellsOfFilledVoids.push_back(hole.cell);
    }
  }
  std::sort(result.cellsOfFilledVoids.begin(), result.cellsOfFilledVoids.end());
  return result;
}
} // namespace tissue
