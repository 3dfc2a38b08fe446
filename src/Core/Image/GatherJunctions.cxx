/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Image/GatherJunctions.h"

#include "Common/Algorithms.h"
#include "Image/ClusterJunctions.h"

#include <algorithm>
#include <iterator>

namespace tissue
{
namespace
{
using Scans = std::vector<const BlockScan *>;

/** The vertices of each scan's cells, by the scan's own numbers of them. */
using VertexMaps = std::vector<std::vector<VertexId>>;

/** Finds the first of 0, -1, -2, ... that is none of the given labels, which must be sorted. */
Label
FindFreeLabel(const std::vector<Label> & labels)
{
  Label label = 0;
  while (std::binary_search(labels.cbegin(), labels.cend(), label))
  {
    --label;
  }
  return label;
}

/** That of the exterior's vertex among them. */
std::vector<Label>
ListLabels(const ExteriorLabels & exterior, Label ofVertex)
{
  std::vector<Label> labels = exterior.others;
  labels.push_back(ofVertex);
  if (!exterior.zeroIsCell)
  {
    labels.push_back(0);
  }
  SortUnique(labels);
  return labels;
}

/** Makes a cell of each label that any scan met, in ascending order after the exterior, and marks those that have a
 * voxel on the border. Returns the maps from the scans' numbers to these vertices. */
VertexMaps
MakeCells(const Scans & scans, const ExteriorLabels & exterior, std::vector<Cell> & cells)
{
  std::vector<Label> labels;
  for (const BlockScan * scan : scans)
  {
    const std::vector<Label> & found = scan->GetLabels().GetLabels();
    labels.insert(labels.end(), found.cbegin() + 1, found.cend());
  }
  SortUnique(labels);

  cells.resize(labels.size() + 1);
  cells[ExteriorVertex].label = exterior.hasLabel ? exterior.label : FindFreeLabel(labels);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    cells[i + 1].label = labels[i];
  }
  VertexMaps maps;
  for (const BlockScan * scan : scans)
  {
    std::vector<VertexId> map(1, ExteriorVertex);
    const auto &          found = scan->GetLabels().GetLabels();
    std::transform(found.cbegin() + 1, found.cend(), std::back_inserter(map), [&labels](Label label) {
      return static_cast<VertexId>(std::lower_bound(labels.cbegin(), labels.cend(), label) - labels.cbegin() + 1);
    });
    const std::vector<bool> & touchesBorder = scan->GetTouchesBorder();
    for (std::size_t i = 1; i < touchesBorder.size(); ++i)
    {
      cells[map[i]].touchesBorder = cells[map[i]].touchesBorder || touchesBorder[i];
    }
    maps.push_back(std::move(map));
  }
  return maps;
}

/** Joins the scans' pieces to those of the whole image. The elements of the sets are the pieces of all scans, one scan
 * after the other. */
DisjointSets
JoinPieces(const Scans & scans)
{
  DisjointSets sets;
  std::int64_t previousOffset = 0;
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    const auto   offset = static_cast<std::int64_t>(sets.GetSize());
    DisjointSets ownSets = scans[i]->GetPieceSets();
    for (std::size_t piece = 0; piece < ownSets.GetSize(); ++piece)
    {
      sets.Unite(sets.Add(), offset + ownSets.Find(static_cast<std::int64_t>(piece)));
    }
    if (i > 0)
    {
      // The last plane of a scan is fed to the next one as its first: the runs are the same, and their pieces there are
      // the first ones.
      const auto & runs = scans[i - 1]->GetLastRuns();
      for (std::size_t run = 0; run < runs.size(); ++run)
      {
        sets.Unite(previousOffset + runs[run].piece, offset + static_cast<std::int64_t>(run));
      }
    }
    previousOffset = offset;
  }
  return sets;
}

/** Sums up each piece of the image, at the place of its set's root; all other entries stay empty. */
std::vector<BlockScan::Piece>
SumPieces(const Scans & scans, const VertexMaps & maps, DisjointSets & sets)
{
  std::vector<BlockScan::Piece> pieces(sets.GetSize());
  std::int64_t                  index = 0;
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    for (const BlockScan::Piece & part : scans[i]->GetPieces())
    {
      BlockScan::Piece & piece = pieces[sets.Find(index++)];
      piece.cell = maps[i][part.cell];
      piece.numberOfVoxels += part.numberOfVoxels;
      for (int axis = 0; axis < 3; ++axis)
      {
        piece.sum[axis] += part.sum[axis];
      }
    }
  }
  return pieces;
}

/** Takes from the pieces what they tell of the cells: numbers of voxels and pieces, the centroid of the largest piece,
 * and how many voxels are astray, outside of it. Padded coordinates are one more than indices. */
void
MeasureCells(const std::vector<BlockScan::Piece> & pieces, const BlockScan::Index & size, std::vector<Cell> & cells)
{
  // Of several largest pieces the first in raster order is taken.
  std::vector<const BlockScan::Piece *> largest(cells.size(), nullptr);
  std::int64_t                          voxelsOfCells = 0;
  for (Cell & cell : cells)
  {
    cell.numberOfPieces = 0;
  }
  for (const BlockScan::Piece & piece : pieces)
  {
    if (piece.numberOfVoxels > 0)
    {
      Cell & cell = cells[piece.cell];
      cell.numberOfVoxels += piece.numberOfVoxels;
      ++cell.numberOfPieces;
      if (largest[piece.cell] == nullptr || piece.numberOfVoxels > largest[piece.cell]->numberOfVoxels)
      {
        largest[piece.cell] = &piece;
      }
    }
  }
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    cells[i].numberOfStrayVoxels = cells[i].numberOfVoxels - largest[i]->numberOfVoxels;
    voxelsOfCells += cells[i].numberOfVoxels;
    for (int axis = 0; axis < 3; ++axis)
    {
      cells[i].center[axis] =
        static_cast<double>(largest[i]->sum[axis]) / static_cast<double>(largest[i]->numberOfVoxels) - 1.0;
    }
  }
  // Piece 0 is the exterior around the image and includes the padding. What is not in it is astray; the number of the
  // exterior's voxels is what the cells leave of the image, without the padding.
  Cell & exterior = cells[ExteriorVertex];
  exterior.numberOfStrayVoxels = exterior.numberOfVoxels - pieces[0].numberOfVoxels;
  exterior.numberOfVoxels = static_cast<std::int64_t>(size[0]) * size[1] * size[2] - voxelsOfCells;
}

template <std::size_t VLength>
std::array<VertexId, VLength>
ToVertices(std::array<VertexId, VLength> cells, const std::vector<VertexId> & map)
{
  for (VertexId & cell : cells)
  {
    cell = map[cell];
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

/** Makes a wall of its faces' sums. A face is half a voxel below the voxel of which the sums hold the padded
 * coordinates; faces weigh by their area. */
Wall
MakeWall(const BlockScan::WallTable::Entry & entry, const Point & spacing)
{
  Wall wall;
  wall.cells = entry.key;
  for (int axis = 0; axis < 3; ++axis)
  {
    const BlockScan::Faces & faces = entry.value[axis];
    const double             faceArea = spacing[(axis + 1) % 3] * spacing[(axis + 2) % 3];
    const auto               numberOfFaces = static_cast<double>(faces.numberOfFaces);
    wall.numberOfFaces += faces.numberOfFaces;
    wall.area += faceArea * numberOfFaces;
    for (int i = 0; i < 3; ++i)
    {
      wall.center[i] += faceArea * (static_cast<double>(faces.sum[i]) - (i == axis ? 1.5 : 1.0) * numberOfFaces);
    }
  }
  for (double & coordinate : wall.center)
  {
    coordinate /= wall.area;
  }
  return wall;
}

template <typename TItem>
void
SortByCells(std::vector<TItem> & items)
{
  std::sort(items.begin(), items.end(), [](const TItem & a, const TItem & b) { return a.cells < b.cells; });
}

std::vector<Wall>
GatherWalls(const Scans & scans, const VertexMaps & maps, const Point & spacing)
{
  BlockScan::WallTable table;
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    for (const auto & entry : scans[i]->GetWalls().GetEntries())
    {
      auto & sums = table[ToVertices(entry.key, maps[i])];
      for (int axis = 0; axis < 3; ++axis)
      {
        sums[axis].numberOfFaces += entry.value[axis].numberOfFaces;
        for (int k = 0; k < 3; ++k)
        {
          sums[axis].sum[k] += entry.value[axis].sum[k];
        }
      }
    }
  }
  std::vector<Wall> walls;
  for (const auto & entry : table.GetEntries())
  {
    walls.push_back(MakeWall(entry, spacing));
  }
  SortByCells(walls);
  return walls;
}

std::vector<TripleLine>
GatherTripleLines(const Scans & scans, const VertexMaps & maps)
{
  BlockScan::TripleTable table;
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    for (const auto & entry : scans[i]->GetTriples().GetEntries())
    {
      table[ToVertices(entry.key, maps[i])] += entry.value;
    }
  }
  std::vector<TripleLine> lines;
  for (const auto & entry : table.GetEntries())
  {
    lines.emplace_back();
    lines.back().cells = entry.key;
    lines.back().numberOfBlocks = entry.value;
  }
  SortByCells(lines);
  return lines;
}

std::vector<Junction>
GatherQuadruples(const Scans & scans, const VertexMaps & maps)
{
  std::vector<BlockScan::Quadruple> quadruples;
  for (std::size_t i = 0; i < scans.size(); ++i)
  {
    for (BlockScan::Quadruple quadruple : scans[i]->GetQuadruples())
    {
      quadruple.cells = ToVertices(quadruple.cells, maps[i]);
      quadruples.push_back(quadruple);
    }
  }
  return ClusterJunctions(std::move(quadruples));
}
} // namespace

JunctionSet
GatherJunctions(const Scans & scans, const BlockScan::Index & size, const Point & spacing,
                const ExteriorLabels & exterior)
{
  // Cells come first, as they give all else its numbers. The walls then tell which cells touch the exterior.
  JunctionSet      set;
  const VertexMaps maps = MakeCells(scans, exterior, set.cells);
  DisjointSets     pieceSets = JoinPieces(scans);
  MeasureCells(SumPieces(scans, maps, pieceSets), size, set.cells);
  for (Cell & cell : set.cells)
  {
    cell.volume = static_cast<double>(cell.numberOfVoxels) * spacing[0] * spacing[1] * spacing[2];
  }
  set.walls = GatherWalls(scans, maps, spacing);
  for (const Wall & wall : set.walls)
  {
    if (wall.cells[0] == ExteriorVertex)
    {
      set.cells[wall.cells[1]].touchesExterior = true;
    }
  }
  set.tripleLines = GatherTripleLines(scans, maps);
  set.junctions = GatherQuadruples(scans, maps);
  for (const BlockScan * scan : scans)
  {
    set.numberOfCrowdedBlocks += scan->GetNumberOfCrowdedBlocks();
  }
  set.exteriorLabels = ListLabels(exterior, set.cells[ExteriorVertex].label);
  return set;
}
} // namespace tissue
