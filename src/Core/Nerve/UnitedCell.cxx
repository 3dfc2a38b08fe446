/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Nerve/UnitedCell.h"

#include "TissueTessellationCore/Common/DisjointSets.h"

#include <algorithm>
#include <map>

namespace tissue
{
bool
HasOnlySpheres(const GeneralComplex & complex, const std::vector<VertexId> & cellOf, VertexId cell)
{
  // Corners of the surface are the tetrahedra that have vertices of the cell and others, lines the triangles that do,
  // walls the edges that do.
  const auto isOfCell = [&](TetrahedronId id, int i) { return cellOf[complex.GetTetrahedron(id).vertices[i]] == cell; };
  const auto isMixed = [&](TetrahedronId id, int without) {
    int count = 0;
    int inside = 0;
    for (int i = 0; i < 4; ++i)
    {
      count += i != without ? 1 : 0;
      inside += i != without && isOfCell(id, i) ? 1 : 0;
    }
    return inside > 0 && inside < count;
  };
  std::vector<TetrahedronId>           corners;
  std::map<TetrahedronId, std::size_t> indexOf;
  constexpr int                        none = -1;
  for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
  {
    if (complex.IsAlive(id) && isMixed(id, none))
    {
      indexOf[id] = corners.size();
      corners.push_back(id);
    }
  }
  DisjointSets     sets(corners.size());
  std::vector<int> euler(corners.size(), 0);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (isMixed(corners[c], i))
      {
        sets.Unite(c, indexOf.at(complex.GetTetrahedron(corners[c]).neighbors[i]));
      }
    }
  }
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    int & ofSurface = euler[sets.Find(c)];
    ofSurface += 1;
    for (int i = 0; i < 4; ++i)
    {
      ofSurface -= isMixed(corners[c], i) && corners[c] < complex.GetTetrahedron(corners[c]).neighbors[i] ? 1 : 0;
      for (int j = i + 1; j < 4; ++j)
      {
        const bool isWall = isOfCell(corners[c], i) != isOfCell(corners[c], j);
        if (isWall)
        {
          // An edge counts at the first of the tetrahedra around it.
          const EdgeRing ring = complex.GetRing({ corners[c], i, j });
          ofSurface += std::all_of(
            ring.begin(), ring.end(), [&](const RingStep & step) { return corners[c] <= step.tetrahedron; });
        }
      }
    }
  }
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    if (static_cast<std::size_t>(sets.Find(c)) == c && euler[c] != 2)
    {
      return false;
    }
  }
  return true;
}
} // namespace tissue
