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
/** \brief Moves the points of a mesh to the image: points within a wall and on a line to where the indicators of their
 * two or three cells are equal, corners halfway to their given places.
 *
 * Each face of a wall in the image, or edge of a line, belongs to the nearest point of that wall or line. A point whose
 * faces or edges are on average farther from it than the edge length goes to their centroid, and so does one that no
 * indicator reaches; if none are its own, it goes to the nearest one. Bulging walls and curved lines are followed in
 * this way. Points of walls and lines that are missing in the image stay. */
class WallProjection
{
public:
  /** `edgeLengths` has the length of an edge for each wall, `corners` the places that the first points of the mesh are
   * to have. The volume, the field and the faces must outlive this object. */
  WallProjection(const WallMesh & mesh, const LabelVolume & volume, const IndicatorField & field,
                 const ImagePlaces & faces, const std::vector<double> & edgeLengths,
                 const std::vector<Point> & corners);

  /** To be called after the walls were remeshed within their lines. The points of the lines must have kept their
   * numbers.
   */
  void
  SetWalls(const WallMesh & mesh, const std::vector<double> & edgeLengths);

  /** Moves all points once. Since the constructor or SetWalls() the mesh may have changed only the positions of its
   * points. */
  void
  Move(WallMesh & mesh, const Execution & execution = Execution()) const;

private:
  /** The points that follow the same cells, and the places of these cells' wall or line in the image. */
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
  /** The groups of all walls, followed by those of the lines. */
  std::vector<Group> m_Groups;
};
} // namespace tissue

#endif
