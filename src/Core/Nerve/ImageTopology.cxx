/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/ImageTopology.h"

#include "Nerve/HandleCutting.h"
#include "Nerve/VertexLinks.h"

#include <algorithm>
#include <numeric>

namespace tissue
{
namespace
{
/** The cells of the image that have not one sphere for a link. */
std::vector<VertexId>
FindUnsoundCells(const GeneralComplex & complex, const TissuePlaces & places)
{
  std::vector<bool> isInImage(static_cast<std::size_t>(complex.NumberOfVertices()), false);
  for (const ImageWall & wall : places.walls)
  {
    isInImage[wall.cells[0]] = true;
    isInImage[wall.cells[1]] = true;
  }
  const VertexLinks     links = FindVertexLinks(complex);
  std::vector<VertexId> unsound;
  for (VertexId v = 0; v < complex.NumberOfVertices(); ++v)
  {
    const bool isSphere = links.NumberOfLinks(v) == 1 && links.links[links.firstOfVertex[v]].eulerCharacteristic == 2;
    if (isInImage[v] && !isSphere && !complex.IsOutside(v))
    {
      unsound.push_back(v);
    }
  }
  return unsound;
}

/** Of each vertex of the image and of each large fragment the vertex of the image. */
std::vector<VertexId>
CellsWithFragments(const Fragments & fragments)
{
  std::vector<VertexId> cellOf(static_cast<std::size_t>(fragments.numberOfVertices));
  std::iota(cellOf.begin(), cellOf.end(), ExteriorVertex);
  for (const Fragment & fragment : fragments.fragments)
  {
    if (fragment.isLarge)
    {
      cellOf[fragment.vertex] = fragment.cell;
    }
  }
  return cellOf;
}

/** Puts the nerve of the divided image in the place of the image's, and the places of both. */
void
TakeDivision(const LabelDivision & division, ImageTopology & topology, const Execution & execution)
{
  const std::vector<CrowdedBlock> blocks = FindCrowdedBlocks(division.volume, execution);
  topology.places = { FindImageWalls(division.volume, execution), FindCornerPlaces(division.volume, blocks) };
  topology.nerve = MakeImageNerve(division.volume, division.NumberOfVertices(), blocks, execution);
  std::vector<VertexId> outside;
  for (VertexId v = ExteriorVertex + 1; v < division.NumberOfVertices(); ++v)
  {
    if (division.realOf[static_cast<std::size_t>(v)] == ExteriorVertex)
    {
      outside.push_back(v);
    }
  }
  topology.nerve.complex.SetOutside(std::move(outside));
}

/** Divides what walls of the image need it, and what is around others, then the cells that are split all the same:
 * around several others. */
void
DivideWhereNeeded(LabelDivision & division, std::vector<KuhnEdge> faulty, std::vector<SplitCell> around,
                  ImageTopology & topology, const Execution & execution)
{
  if (Divide(division, std::move(faulty), std::move(around)))
  {
    TakeDivision(division, topology, execution);
  }
  // Of a cell around others that is around others each pass divides one more.
  constexpr int maximumNumberOfPasses = 3;
  for (int pass = 0; pass < maximumNumberOfPasses; ++pass)
  {
    auto split = FindSplitCells(division.volume, topology.places.walls, topology.nerve.complex);
    if (split.empty() || !Divide(division, {}, std::move(split)))
    {
      return;
    }
    TakeDivision(division, topology, execution);
  }
}

/** Gives small fragments and what makes handles to other cells, in a copy of the image where it has any. */
void
MakeCellsBalls(const LabelVolume & volume, ImageTopology & topology, const Execution & execution)
{
  const VertexId numberOfVertices = topology.fragments.numberOfVertices;
  LabelVolume &  copy = topology.volume;
  Relabel(copy, topology.fragments.ofSmall);
  const LabelVolume & image = copy.vertices.empty() ? volume : copy;
  auto                characteristics = FindEulerCharacteristics(image, numberOfVertices, execution);
  if (std::all_of(characteristics.begin() + 1, characteristics.end(), [](std::int32_t c) { return c == 1; }))
  {
    return;
  }
  if (copy.vertices.empty())
  {
    copy = volume;
  }
  topology.handles = CutHandles(copy, std::move(characteristics)).cells;
}

/** Finds the fragments, the places and the nerve. */
void
ReadImage(const LabelVolume & volume, VertexId numberOfVertices, std::int64_t minimumFragmentVoxels,
          ImageTopology & topology, const Execution & execution)
{
  topology.fragments = FindFragments(volume, numberOfVertices, minimumFragmentVoxels);
  LabelVolume &       copy = topology.volume;
  const LabelVolume * image = &volume;
  if (!topology.fragments.fragments.empty())
  {
    copy = volume;
    image = &copy;
  }
  Relabel(copy, topology.fragments.ofLarge);
  std::vector<CrowdedBlock> blocks = FindCrowdedBlocks(*image, execution);
  topology.places = { FindImageWalls(*image, execution), FindCornerPlaces(*image, blocks) };
  execution.Report(0.4);
  MakeCellsBalls(volume, topology, execution);
  if (!copy.vertices.empty())
  {
    image = &copy;
    blocks = FindCrowdedBlocks(*image, execution);
  }
  topology.nerve = MakeImageNerve(*image, topology.fragments.numberOfVertices, blocks, execution);
  execution.Report(0.6);
  auto          faulty = FindFaultyWalls(*image, topology.places.walls, topology.nerve.complex);
  auto          around = FindCellsAround(*image, topology.places.walls, topology.fragments.numberOfVertices);
  LabelDivision division({}, topology.fragments.numberOfVertices);
  if (!faulty.empty() || !around.empty() ||
      !FindSplitCells(*image, topology.places.walls, topology.nerve.complex).empty())
  {
    division.volume = image == &copy ? std::move(copy) : volume;
    DivideWhereNeeded(division, std::move(faulty), std::move(around), topology, execution);
    copy = std::move(division.volume);
  }
  topology.divided = division.FindDividedCells();
  const std::vector<VertexId> cellOf = CellsWithFragments(topology.fragments);
  topology.cellOf = std::move(division.realOf);
  std::transform(
    topology.cellOf.begin(), topology.cellOf.end(), topology.cellOf.begin(), [&](VertexId v) { return cellOf[v]; });
  execution.Report(0.7);
}
} // namespace

ImageTopology
FindImageTopology(const LabelVolume & volume, VertexId numberOfVertices, const ImageTopologyParameters & parameters,
                  const Execution & execution, const NerveVisitor & visit)
{
  ImageTopology topology;
  ReadImage(volume, numberOfVertices, parameters.minimumFragmentVoxels, topology, execution);
  if (visit)
  {
    visit(topology);
  }
  topology.repairs = Repair(topology.nerve, topology.places);
  topology.descent = Descend(
    topology.nerve.complex, topology.places, parameters.preferences, parameters.votes, execution.Part(0.75, 1.0));
  topology.unsoundCells = FindUnsoundCells(topology.nerve.complex, topology.places);
  return topology;
}
} // namespace tissue
