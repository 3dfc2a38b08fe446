/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallProjection_h
#define TissueTessellationCore_WallProjection_h

#include "Fitting/CellsAtPoint.h"
#include "Image/ImagePlaces.h"
#include "Image/IndicatorField.h"
#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief What a complex has to do with the image that its walls are fitted to. */
struct ComplexImage
{
  /** The image by the vertices of the complex. */
  const LabelVolume & volume;
  /** The cell of each vertex. */
  const std::vector<VertexId> & cellOf;
  /** The two vertices of each wall of the mesh. */
  const std::vector<VertexPair> & pairs;
};

/** \brief Moves the points of a mesh to the image: points within a wall and on a line to where the indicators of their
 * two or three cells are equal, corners halfway to their given places. On the seams of a divided cell the corners and
 * lines of the complex are points of fewer cells, and are moved like these.
 *
 * Each face of a wall in the image, or edge of a line, belongs to the nearest point of that wall or line. A point whose
 * faces or edges are on average farther from it than the edge length goes to their centroid, and so does one that no
 * indicator reaches; if none are its own, it goes to the nearest one. Bulging walls and curved lines are followed in
 * this way. Points of walls and lines that are missing in the image stay. */
class WallProjection
{
public:
  /** \param mesh with corners as its first points.
   * \param complex the two vertices of the complex of each wall, and the image by them.
   * \param faces those of the walls (CollectWallFaces()).
   * \param edgeLengths the length of an edge for each wall.
   * \param corners the places that the corners are to have.
   *
   * All but the last two must outlive this object. */
  WallProjection(const WallMesh & mesh, const ComplexImage & complex, const IndicatorField & field,
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
    CellsAtPoint               at;
    VertexTriple               vertices = { { -1, -1, -1 } };
    double                     edgeLength = 0.0;
    std::vector<PointId>       points;
    const ImagePlaces::Place * begin = nullptr;
    const ImagePlaces::Place * end = nullptr;
  };

  void
  CollectLines(const WallMesh & mesh);
  void
  MoveGroup(const Group & group, WallMesh & mesh) const;

  ComplexImage             m_Complex;
  const IndicatorField &   m_Field;
  const ImagePlaces &      m_Faces;
  const std::vector<Point> m_Corners;
  /** The cells at each of the corners. */
  std::vector<CellsAtPoint> m_CellsAtCorners;
  ImagePlaces               m_LinePlaces;
  std::vector<Group>        m_Lines;
  /** The groups of all walls, followed by those of the lines. */
  std::vector<Group> m_Groups;
};
} // namespace tissue

#endif
