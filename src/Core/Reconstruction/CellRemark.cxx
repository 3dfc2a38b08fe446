/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/CellRemark.h"

#include "Adjacency/ReferenceAdjacency.h"
#include "Common/Algorithms.h"
#include "Complex/AdjacencyComplex.h"
#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <tuple>

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
    "is in several pieces; {value} voxels outside the largest one do not count for its centre",
    "in several pieces; the largest counts" },
  { Remark::CutByBorder,
    "cutByBorder",
    "lies on the border of the image and may be cut there",
    "on the border of the image, where they may be cut" },
  { Remark::Enclosed,
    "enclosed",
    "is enclosed in the cell of label {value}; it has false walls in the mesh",
    "enclosed in one other cell" },
  { Remark::Separated, "separated", "touches no other cell", "without a neighbour in the image" },
  { Remark::StrayPart,
    "strayPart",
    "is in a small part of the tissue that touches no other; false walls join it to the nearest part",
    "in small parts that touch no other, joined to the nearest part by false walls" },
  { Remark::SeparateWalls,
    "separateWalls",
    "has several separate walls to each of {value} neighbour{s}; the mesh has one",
    "with several separate walls to one neighbour in the image; the mesh has one" },
  { Remark::ExteriorOnTwoSides,
    "exteriorOnTwoSides",
    "meets the exterior on two sides, as in a sheet of one layer; the mesh has one",
    "at the exterior on two sides in the image; the mesh has one" },
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
CountWalls(const AdjacencyComplex & complex, const JunctionSet & junctions)
{
  std::vector<WallCounts> counts(static_cast<std::size_t>(junctions.NumberOfVertices()));
  for (const Wall & wall : junctions.walls)
  {
    const bool isLost = !complex.FindEdge(wall.cells[0], wall.cells[1]);
    for (int side = 0; side < 2; ++side)
    {
      WallCounts & count = counts[wall.cells[side]];
      ++count.inImage;
      count.lost += isLost ? 1 : 0;
      count.neighbor = wall.cells[1 - side];
    }
  }
  const ReferenceAdjacency reference(junctions);
  for (const AdjacencyComplex::Edge & edge : complex.GetEdges())
  {
    if (!reference.HasPair(edge.vertices[0], edge.vertices[1]))
    {
      ++counts[edge.vertices[0]].gained;
      ++counts[edge.vertices[1]].gained;
    }
  }
  return counts;
}

bool
TouchesExterior(const AdjacencyComplex & complex, const JunctionSet & junctions, VertexId v)
{
  bool touches = complex.FindEdge(ExteriorVertex, v) != nullptr;
  for (auto outside = static_cast<VertexId>(junctions.cells.size()); outside < complex.NumberOfVertices(); ++outside)
  {
    touches = touches || complex.FindEdge(outside, v);
  }
  return touches;
}

/** Two cells and two others that meet them at a junction of the image. */
struct WallLink
{
  VertexPair cells;
  VertexPair others;
  bool       isExact; // no fifth cell is there

  friend bool
  operator<(const WallLink & a, const WallLink & b)
  {
    return std::tie(a.cells, a.others) < std::tie(b.cells, b.others);
  }
};

std::vector<WallLink>
CollectWallLinks(const JunctionSet & junctions)
{
  std::vector<WallLink> links;
  links.reserve(6 * junctions.junctions.size());
  for (const Junction & junction : junctions.junctions)
  {
    const VertexQuadruple & c = junction.cells;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        const int k = i == 0 ? (j == 1 ? 2 : 1) : 0;
        links.push_back({ { { c[i], c[j] } }, { { c[k], c[6 - i - j - k] } }, junction.numberOfExactBlocks > 0 });
      }
    }
  }
  std::sort(links.begin(), links.end());
  return links;
}

/** The walls of two cells from their links. The junctions of one wall are a cycle around it: several walls are several
 * components of the links, or several cycles where they have a neighbour in common. Links of crowded blocks are chords,
 * and make no cycles. */
int
CountWallsOfLinks(const WallLink * begin, const WallLink * end)
{
  std::vector<VertexId> others;
  for (const WallLink * link = begin; link != end; ++link)
  {
    others.insert(others.end(), link->others.begin(), link->others.end());
  }
  SortUnique(others);
  const auto indexOf = [&others](VertexId v) {
    return std::lower_bound(others.begin(), others.end(), v) - others.begin();
  };
  DisjointSets sets(others.size());
  auto         components = static_cast<int>(others.size());
  int          cycles = 0;
  for (const bool isExact : { true, false })
  {
    for (const WallLink * link = begin; link != end; ++link)
    {
      if (link->isExact == isExact)
      {
        const auto a = indexOf(link->others[0]);
        const auto b = indexOf(link->others[1]);
        const bool isCycle = sets.Find(a) == sets.Find(b);
        cycles += isExact && isCycle ? 1 : 0;
        components -= isCycle ? 0 : 1;
        sets.Unite(a, b);
      }
    }
  }
  return std::max(cycles, components);
}

/** Of each vertex the number of its neighbours in the image to which it has several separate walls. */
std::vector<int>
CountSeparateWalls(const JunctionSet & junctions)
{
  const std::vector<WallLink> links = CollectWallLinks(junctions);
  std::vector<int>            counts(static_cast<std::size_t>(junctions.NumberOfVertices()), 0);
  for (auto begin = links.begin(); begin != links.end();)
  {
    const auto end =
      std::find_if(begin, links.end(), [begin](const WallLink & link) { return link.cells != begin->cells; });
    if (CountWallsOfLinks(&*begin, &*begin + (end - begin)) > 1)
    {
      ++counts[begin->cells[0]];
      ++counts[begin->cells[1]];
    }
    begin = end;
  }
  return counts;
}

/** A vertex's junctions with the exterior, and those of them that are at several places. */
struct SurfaceJunctions
{
  int number = 0;
  int numberOfDouble = 0;
};

std::vector<SurfaceJunctions>
CountSurfaceJunctions(const JunctionSet & junctions)
{
  std::vector<SurfaceJunctions> counts(static_cast<std::size_t>(junctions.NumberOfVertices()));
  for (const Junction & junction : junctions.junctions)
  {
    for (int i = 1; junction.cells[0] == ExteriorVertex && i < 4; ++i)
    {
      ++counts[junction.cells[i]].number;
      counts[junction.cells[i]].numberOfDouble += junction.numberOfClusters > 1 ? 1 : 0;
    }
  }
  return counts;
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
CollectRemarks(const AdjacencyComplex & complex, const JunctionSet & junctions)
{
  const std::vector<WallCounts>       counts = CountWalls(complex, junctions);
  const std::vector<int>              separateWalls = CountSeparateWalls(junctions);
  const std::vector<SurfaceJunctions> surface = CountSurfaceJunctions(junctions);
  std::vector<CellRemark>             remarks;
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
    const bool isInExterior = count.neighbor == ExteriorVertex || junctions.IsVoid(count.neighbor);
    const bool touches = TouchesExterior(complex, junctions, v);
    add(cell.numberOfPieces > 1, Remark::SeveralPieces, static_cast<double>(cell.numberOfStrayVoxels));
    add(cell.touchesBorder, Remark::CutByBorder, 0.0);
    add(isAlone && !isInExterior, Remark::Enclosed, static_cast<double>(junctions.CellOfVertex(count.neighbor).label));
    add(isAlone && isInExterior, Remark::Separated, 0.0);
    add(separateWalls[v] > 0, Remark::SeparateWalls, separateWalls[v]);
    // All of them double: the two sides of a sheet. Some of them: a junction that is cut up.
    add(surface[v].numberOfDouble > 2 && 2 * surface[v].numberOfDouble > surface[v].number,
        Remark::ExteriorOnTwoSides,
        surface[v].numberOfDouble);
    add(cell.touchesExterior && !touches, Remark::ExteriorLost, 0.0);
    add(!cell.touchesExterior && touches, Remark::ExteriorGained, 0.0);
    add(count.lost > 0, Remark::WallsLost, count.lost);
    add(count.gained > 0, Remark::WallsGained, count.gained);
  }
  return remarks;
}
} // namespace tissue
