/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CellsAtPoint_h
#define TissueTessellationCore_CellsAtPoint_h

#include "TissueTessellationCore/Common/Types.h"

#include <algorithm>
#include <vector>

namespace tissue
{
/** The different cells that meet at a point of a mesh: up to four, the exterior counted. */
struct CellsAtPoint
{
  VertexQuadruple cells = { { -1, -1, -1, -1 } };
  int             count = 0;

  /** A fifth one is left out. */
  void
  Add(VertexId cell)
  {
    const auto end = cells.begin() + count;
    if (count < 4 && std::find(cells.begin(), end, cell) == end)
    {
      cells[count++] = cell;
    }
  }
};

/** Those of vertices of a complex, by the cell of each vertex; -1 among the vertices stands for none. */
template <std::size_t VLength>
CellsAtPoint
CellsOfVertices(const std::array<VertexId, VLength> & vertices, const std::vector<VertexId> & cellOf)
{
  CellsAtPoint at;
  for (const VertexId v : vertices)
  {
    if (v >= 0)
    {
      at.Add(cellOf[v]);
    }
  }
  return at;
}
} // namespace tissue

#endif
