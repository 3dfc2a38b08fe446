/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/CellRemark.h"

#include "TissueTessellationCore/AdjacencyComplex.h"
#include "TissueTessellationCore/ReferenceAdjacency.h"

#include <sstream>

namespace tissue
{
namespace
{
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
  std::vector<WallCounts> counts(junctions.cells.size());
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
} // namespace

const char *
ToString(Remark remark)
{
  switch (remark)
  {
    case Remark::SeveralPieces:
      return "severalPieces";
    case Remark::CutByBorder:
      return "cutByBorder";
    case Remark::Enclosed:
      return "enclosed";
    case Remark::Separated:
      return "separated";
    case Remark::StrayPart:
      return "strayPart";
    case Remark::CenterMoved:
      return "centerMoved";
    case Remark::ExteriorLost:
      return "exteriorLost";
    case Remark::ExteriorGained:
      return "exteriorGained";
    case Remark::WallsLost:
      return "wallsLost";
    case Remark::WallsGained:
      return "wallsGained";
    case Remark::VolumeOff:
      return "volumeOff";
    case Remark::CornersNotFitted:
      return "cornersNotFitted";
    case Remark::VolumeNotFitted:
      return "volumeNotFitted";
  }
  return "unknown";
}

std::string
Describe(const CellRemark & remark)
{
  std::ostringstream text;
  switch (remark.remark)
  {
    case Remark::SeveralPieces:
      text << "is in several pieces; " << remark.value << " voxels outside the largest one do not count for its centre";
      break;
    case Remark::CutByBorder:
      text << "lies on the border of the image and may be cut there";
      break;
    case Remark::Enclosed:
      text << "is enclosed in the cell of label " << remark.value << "; it has false walls in the mesh";
      break;
    case Remark::Separated:
      text << "touches no other cell";
      break;
    case Remark::StrayPart:
      text << "is in a small part of the tissue that touches no other; false walls join it to the nearest part";
      break;
    case Remark::CenterMoved:
      text << "had the same centre as another cell; moved by " << remark.value;
      break;
    case Remark::ExteriorLost:
      text << "touches the exterior in the image, but not in the mesh";
      break;
    case Remark::ExteriorGained:
      text << "touches the exterior in the mesh, but not in the image";
      break;
    case Remark::WallsLost:
      text << "lost " << remark.value << (remark.value == 1.0 ? " wall" : " walls") << " that the image has";
      break;
    case Remark::WallsGained:
      text << "has " << remark.value << (remark.value == 1.0 ? " wall" : " walls") << " that the image has not";
      break;
    case Remark::CornersNotFitted:
      text << "has " << remark.value << (remark.value == 1.0 ? " corner" : " corners") << " that the image has not";
      break;
    case Remark::VolumeOff:
    case Remark::VolumeNotFitted:
      text << "has " << remark.value << " times its volume in the image";
      break;
  }
  return text.str();
}

std::vector<CellRemark>
CollectRemarks(const AdjacencyComplex & complex, const JunctionSet & junctions)
{
  const std::vector<WallCounts> counts = CountWalls(complex, junctions);
  std::vector<CellRemark>       remarks;
  for (VertexId v = ExteriorVertex + 1; v < complex.NumberOfVertices(); ++v)
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
    const bool touches = complex.FindEdge(ExteriorVertex, v) != nullptr;
    add(cell.numberOfPieces > 1, Remark::SeveralPieces, static_cast<double>(cell.numberOfStrayVoxels));
    add(cell.touchesBorder, Remark::CutByBorder, 0.0);
    add(isAlone && count.neighbor != ExteriorVertex,
        Remark::Enclosed,
        static_cast<double>(junctions.cells[count.neighbor].label));
    add(isAlone && count.neighbor == ExteriorVertex, Remark::Separated, 0.0);
    add(cell.touchesExterior && !touches, Remark::ExteriorLost, 0.0);
    add(!cell.touchesExterior && touches, Remark::ExteriorGained, 0.0);
    add(count.lost > 0, Remark::WallsLost, count.lost);
    add(count.gained > 0, Remark::WallsGained, count.gained);
  }
  return remarks;
}
} // namespace tissue
