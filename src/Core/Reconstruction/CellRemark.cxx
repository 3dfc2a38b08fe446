/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/CellRemark.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Adjacency/SuspectCells.h"
#include "TissueTessellationCore/Complex/AdjacencyOverlap.h"
#include "TissueTessellationCore/Mesh/CellSurfaceCheck.h"

#include <iterator>
#include <map>
#include <sstream>

namespace tissue
{
namespace
{
/** How a remark is said. */
struct RemarkWords
{
  Remark       remark;
  const char * word;
  /** {value} is the remark's value, {s} the plural of what it counts. */
  const char * ofOne;
  const char * ofSeveral;
};

/** In the order of the enumeration. */
constexpr RemarkWords Words[] = {
  { Remark::SeveralPieces,
    "severalPieces",
    "is in several pieces; {value} voxel{s} outside the largest one do not count for its centre",
    "in several pieces; the largest counts" },
  { Remark::SuspectLarge,
    "suspectLarge",
    "may be no cell: it lies on the border of the image and has {value} times the median volume",
    "that may be none: on the border of the image, and of many times the median volume" },
  { Remark::SuspectPocket,
    "suspectPocket",
    "may be no cell: it lies at the exterior and the border of the image, and has {value} times the median volume",
    "that may be none: large, at the exterior and the border of the image" },
  { Remark::SuspectPieces,
    "suspectPieces",
    "may be no cell: of its voxels {value} are apart from its largest piece",
    "that may be none: in several large pieces" },
  { Remark::CutByBorder,
    "cutByBorder",
    "lies on the border of the image and may be cut there",
    "on the border of the image, where they may be cut" },
  { Remark::Enclosed, "enclosed", "is enclosed in the cell of label {value}", "enclosed in one other cell" },
  { Remark::Separated, "separated", "touches no other cell", "without a neighbour in the image" },
  { Remark::Fragment,
    "fragment",
    "has a piece of {value} voxel{s} apart from the rest, with a closed surface of its own",
    "with pieces that have a closed surface of their own" },
  { Remark::FragmentDropped,
    "fragmentDropped",
    "has a piece of {value} voxel{s} that is too small for a surface of its own, and is not in the mesh",
    "with pieces too small for the mesh" },
  { Remark::RingWalls,
    "ringWalls",
    "has walls that are rings or have no corner; it was taken for {value} piece{s} to mesh them",
    "with walls that are rings or have no corner" },
  { Remark::Repaired,
    "repaired",
    "has {value} false wall{s}, by which its surface is one sphere",
    "with false walls, by which their surface is one sphere" },
  { Remark::HandlesCut,
    "handlesCut",
    "had handles in the image; {value} voxel{s} that closed them went to its neighbours",
    "with handles in the image that are cut in the mesh" },
  { Remark::HandlesKept, "handlesKept", "has {value} handle{s} in the image", "with handles in the image" },
  { Remark::Cavities,
    "cavities",
    "has {value} hole{s} of background within, with a surface of its own each",
    "with holes of background within, which are kept" },
  { Remark::CavitiesFilled,
    "cavitiesFilled",
    "has {value} hole{s} of background within, too small for a surface and filled",
    "with holes of background within that are too small for the mesh, and filled" },
  { Remark::CenterMoved,
    "centerMoved",
    "had the same centre as another cell; moved by {value}",
    "moved, their centre being another cell's too" },
  { Remark::ExteriorLost,
    "exteriorLost",
    "touches the exterior in the image, but not in the mesh",
    "at the exterior in the image, but not in the mesh" },
  { Remark::ExteriorGained,
    "exteriorGained",
    "touches the exterior in the mesh, but not in the image",
    "at the exterior in the mesh, but not in the image" },
  { Remark::WallsLost,
    "wallsLost",
    "lost {value} wall{s} that the image has",
    "without some wall that they have in the image" },
  { Remark::WallsGained,
    "wallsGained",
    "has {value} wall{s} that the image has not",
    "with some wall that they do not have in the image" },
  { Remark::VolumeOff,
    "volumeOff",
    "has {value} times its volume in the image",
    "with less than half or more than twice their volume in the image" },
  { Remark::CornersNotFitted,
    "cornersNotFitted",
    "has {value} corner{s} that the image has not",
    "with corners that the image has not" },
  { Remark::VolumeNotFitted,
    "volumeNotFitted",
    "has {value} times its volume in the image",
    "more than 1 % off their volume in the image, as their walls cannot move further" },
  { Remark::VoxelWalls,
    "voxelWalls",
    "has walls that could not be fitted in {value} place{s}; the mesh has the walls of the voxels",
    "with walls that could not be fitted; the mesh has the walls of the voxels" },
  { Remark::Sharp,
    "sharp",
    "has {value} place{s} with a small angle or a short edge, which could not be mended",
    "with small angles or short edges" },
  { Remark::Missing, "missing", "is missing from the mesh", "missing from the mesh" },
  { Remark::NoClosedSphere,
    "noClosedSphere",
    "has a surface that is no closed sphere; its Euler characteristic is {value}",
    "with a surface that is no closed sphere" }
};

constexpr bool
EveryRemarkHasItsRow()
{
  bool has = std::size(Words) == NumberOfRemarks;
  for (int row = 0; has && row < NumberOfRemarks; ++row)
  {
    has = static_cast<int>(Words[row].remark) == row;
  }
  return has;
}
static_assert(EveryRemarkHasItsRow());

const RemarkWords &
WordsOf(Remark remark)
{
  return Words[static_cast<std::size_t>(remark)];
}

void
Replace(const std::string & mark, const std::string & by, std::string & text)
{
  const std::size_t at = text.find(mark);
  if (at != std::string::npos)
  {
    text.replace(at, mark.size(), by);
  }
}

/** What the image and the complex say of a cell's walls. */
struct WallCounts
{
  int      inImage = 0;
  int      lost = 0;
  int      gained = 0;
  VertexId neighbor = ExteriorVertex; // the last one met in the image
};

std::vector<WallCounts>
CountWalls(const AdjacencyTuples & complex, const JunctionSet & junctions)
{
  std::vector<WallCounts> counts(static_cast<std::size_t>(junctions.NumberOfVertices()));
  for (const Wall & wall : junctions.walls)
  {
    const bool isLost = !complex.HasPair(wall.cells[0], wall.cells[1]);
    for (int side = 0; side < 2; ++side)
    {
      WallCounts & count = counts[wall.cells[side]];
      ++count.inImage;
      count.lost += isLost ? 1 : 0;
      count.neighbor = wall.cells[1 - side];
    }
  }
  const ReferenceAdjacency reference(junctions);
  for (const VertexPair & pair : complex.pairs)
  {
    if (!reference.HasPair(pair[0], pair[1]))
    {
      ++counts[pair[0]].gained;
      ++counts[pair[1]].gained;
    }
  }
  return counts;
}

Remark
RemarkOf(Suspicion suspicion)
{
  switch (suspicion)
  {
    case Suspicion::Large:
      return Remark::SuspectLarge;
    case Suspicion::Pocket:
      return Remark::SuspectPocket;
    default:
      return Remark::SuspectPieces;
  }
}
} // namespace

const char *
ToString(Remark remark)
{
  return WordsOf(remark).word;
}

std::string
Describe(const CellRemark & remark)
{
  std::ostringstream value;
  value << remark.value;
  std::string text = WordsOf(remark.remark).ofOne;
  Replace("{value}", value.str(), text);
  Replace("{s}", remark.value == 1.0 ? "" : "s", text);
  return text;
}

const char *
DescribeSeveral(Remark remark)
{
  return WordsOf(remark).ofSeveral;
}

std::vector<CellRemark>
CollectRemarks(const AdjacencyTuples & complex, const JunctionSet & junctions)
{
  const std::vector<WallCounts>   counts = CountWalls(complex, junctions);
  std::map<VertexId, SuspectCell> suspects;
  for (const SuspectCell & suspect : FindSuspectCells(junctions))
  {
    suspects.emplace(suspect.cell, suspect);
  }
  std::vector<CellRemark> remarks;
  for (VertexId v = ExteriorVertex + 1; v < static_cast<VertexId>(junctions.cells.size()); ++v)
  {
    const Cell &       cell = junctions.cells[v];
    const WallCounts & count = counts[v];
    const auto         add = [&](bool applies, Remark remark, double value) {
      if (applies)
      {
        remarks.push_back({ v, remark, value });
      }
    };
    const bool isAlone = count.inImage == 1;
    const bool isInExterior = count.neighbor == ExteriorVertex;
    const bool touches = complex.HasPair(ExteriorVertex, v);
    add(cell.numberOfPieces > 1, Remark::SeveralPieces, static_cast<double>(cell.numberOfStrayVoxels));
    if (suspects.count(v) > 0)
    {
      add(true, RemarkOf(suspects.at(v).suspicion), suspects.at(v).value);
    }
    add(cell.touchesBorder, Remark::CutByBorder, 0.0);
    add(isAlone && !isInExterior, Remark::Enclosed, static_cast<double>(junctions.cells[count.neighbor].label));
    add(isAlone && isInExterior, Remark::Separated, 0.0);
    add(cell.touchesExterior && !touches, Remark::ExteriorLost, 0.0);
    add(!cell.touchesExterior && touches, Remark::ExteriorGained, 0.0);
    add(count.lost > 0, Remark::WallsLost, count.lost);
    add(count.gained > 0, Remark::WallsGained, count.gained);
  }
  return remarks;
}

std::vector<CellRemark>
CollectRemarks(const CellSurfaceCheck & check)
{
  std::vector<CellRemark> remarks;
  for (const VertexId v : check.cellsWithoutTriangles)
  {
    remarks.push_back({ v, Remark::Missing, 0.0 });
  }
  for (const VertexId v : check.cellsThatAreNoSphere)
  {
    remarks.push_back({ v, Remark::NoClosedSphere, static_cast<double>(check.cells[v].eulerCharacteristic) });
  }
  return remarks;
}
} // namespace tissue
