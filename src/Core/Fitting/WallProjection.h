/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallProjection_h
#define TissueTessellationCore_WallProjection_h

#include "Image/ImagePlaces.h"
#include "Image/IndicatorField.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief Moves the points of a mesh to the image: points within a wall and on a line where the indicators of their two
 * or three cells are equal, corners halfway to their given places.
 *
 * A point that is far from the image's faces (edges) of its wall (line) nearest to it, in the mean by more than the
 * edge length, goes to their centroid, or to the nearest one, as does one that no indicator reaches: so bulging walls
 * and curved lines are followed. Points of walls and lines that the image has not stay. */
class WallProjection
{
public:
  /** `edgeLengths` has a length for each wall, `corners` the places of the first points. The volume, the field and the
   * faces must outlive this object. */
  WallProjection(const WallMesh & mesh, const LabelVolume & volume, const IndicatorField & field,
                 const ImagePlaces & faces, const std::vector<double> & edgeLengths,
                 const std::vector<Point> & corners);

  /** After the walls were remeshed within their lines, whose points keep their numbers. */
  void
  SetWalls(const WallMesh & mesh, const std::vector<double> & edgeLengths);

  /** The mesh may have changed in its points alone. */
  void
  Move(WallMesh & mesh, const Execution & execution = Execution()) const;

private:
  /** Points that follow the same cells. */
  struct Group
  {
    VertexQuadruple            cells = { { -1, -1, -1, -1 } };
    int                        numberOfCells = 0;
    double                     edgeLength = 0.0;
    std::vector<PointId>       points;
    const ImagePlaces::Place * begin = nullptr;
    const ImagePlaces::Place * end = nullptr;
  };

  void
  CollectLines(const WallMesh & mesh, const LabelVolume & volume);
  void
  MoveGroup(const Group & group, WallMesh & mesh) const;

  const IndicatorField &   m_Field;
  const ImagePlaces &      m_Faces;
  const std::vector<Point> m_Corners;
  ImagePlaces              m_LinePlaces;
  std::vector<Group>       m_Lines;
  /** Of the walls, then of the lines. */
  std::vector<Group> m_Groups;
};
} // namespace tissue

#endif
