/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Crossings_h
#define TissueTessellationCore_Crossings_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Geometry/Box.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** The indices of two triangles, of which the smaller is the first. */
using TrianglePair = std::array<std::int32_t, 2>;

/** Finds all pairs of triangles that cross (TriangleCrossing.h), in ascending order. */
std::vector<TrianglePair>
FindCrossings(const WallMesh & mesh, const Execution & execution = Execution());

/** Finds all pairs of triangles that cross and of which one at least is in one of the given walls, in ascending order.
 */
std::vector<TrianglePair>
FindCrossingsOfWalls(const WallMesh & mesh, const std::vector<WallId> & walls,
                     const Execution & execution = Execution());

/** The first triangle of each run of triangles of one wall, and the number of all triangles. The runs are the walls
 * where the triangles are in the order of these. */
std::vector<std::size_t>
FirstTrianglesOfRuns(const WallMesh & mesh);

/** \brief The pairs of triangles that may cross on their way from one place to another, and of which one is marked.
 *
 * The boxes of two such triangles, each about its points both here and there, overlap. Triangles are looked at by runs
 * (FirstTrianglesOfRuns): only those near a marked triangle cost time. */
class ClosePairs
{
public:
  /** `isMarked` must outlive the object. */
  ClosePairs(const WallMesh & mesh, const std::vector<Point> & here, const std::vector<Point> & there,
             const std::vector<unsigned char> & isMarked);

  const std::vector<std::size_t> &
  FirstOfRuns() const
  {
    return m_First;
  }

  /** By run, whether it may have pairs. Its box overlaps that of one with a marked triangle, or most runs have one. */
  const std::vector<unsigned char> &
  NearRuns() const
  {
    return m_IsNear;
  }

  /** Collects the pairs, but not those within the runs that are left out. */
  std::vector<TrianglePair>
  Collect(const std::vector<unsigned char> & isLeftOut, const Execution & execution) const;

  /** Adds the pairs within a run that is near. */
  void
  AppendWithin(std::size_t run, std::vector<TrianglePair> & pairs) const;

private:
  void
  FindNearRuns();

  std::vector<std::size_t>           m_First;
  std::vector<unsigned char>         m_IsNear;
  std::vector<Box>                   m_Boxes;
  const std::vector<unsigned char> & m_IsMarked;
};
} // namespace tissue

#endif
