/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallProjection_h
#define TissueTessellationCore_WallProjection_h

#include "TissueTessellationCore/ImageFaces.h"
#include "TissueTessellationCore/IndicatorField.h"
#include "TissueTessellationCore/JunctionSet.h"

namespace tissue
{
/** \brief Moves the points of a mesh to the image: points within a wall and on a line where the indicators of their two
 * or three cells are equal, corners halfway to their given places.
 *
 * A point of a wall that is far from the wall's image faces nearest to it, in the mean by more than the wall's edge
 * length, goes to their centroid. Points of walls and lines that the image has not stay. `edgeLengths` has a length for
 * each wall; `corners` are the places of the first points. The objects given must outlive this one; the mesh may change
 * in its points alone. */
class WallProjection
{
public:
  WallProjection(const WallMesh & mesh, const JunctionSet & junctions, const IndicatorField & field,
                 const ImageFaces & faces, const std::vector<double> & edgeLengths, const std::vector<Point> & corners);

  void
  Move(WallMesh & mesh, const ParallelFor & parallelFor = ParallelFor()) const;

private:
  void
  MoveLinesAndCorners(WallMesh & mesh, std::size_t begin, std::size_t end) const;
  void
  MoveWall(WallMesh & mesh, WallId wall) const;

  const IndicatorField &      m_Field;
  const ImageFaces &          m_Faces;
  const std::vector<double> & m_EdgeLengths;
  const std::vector<Point> &  m_Corners;
  /** The cells at each point of a line; -1 first where the image has no such line, or for another point. */
  std::vector<VertexTriple> m_LineCells;
  /** The points within each wall. */
  std::vector<std::vector<PointId>> m_Inner;
  std::vector<VertexPair>           m_WallCells;
};
} // namespace tissue

#endif
