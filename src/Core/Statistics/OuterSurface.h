/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_OuterSurface_h
#define TissueTessellationCore_OuterSurface_h

#include "Statistics/SurfaceFit.h"
#include "TissueTessellationCore/Common/CompressedRows.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief A wall of the tissue's surface, without what of it planes cut: the border of the image, or others. */
struct OuterWall
{
  WallId   wall = 0;
  VertexId cell = 0;
  double   area = 0.0;
  Point    center = { { 0.0, 0.0, 0.0 } };
  /** Outwards, its length is the area of the wall as it is seen from there. */
  Point normal = { { 0.0, 0.0, 0.0 } };
  /** The diameter of a ball that has the surface of the cell. */
  double diameter = 0.0;
  /** Whether the tissue is cut here all the same: cells are missing. */
  bool isCut = false;
};

/** \brief The surface of a tissue towards the exterior around it, without the voids that it encloses. */
struct OuterSurface
{
  /** Ascending. */
  std::vector<OuterWall> walls;
  /** Of each, none that a plane cuts; and for each those next to it, across a line of three cells, ascending.
   */
  CompressedRows<SurfaceSample> samples;
  CompressedRows<std::size_t>   neighbors;
  /** By wall of the mesh: the area that planes cut, and all of the walls that are cut. */
  std::vector<double> cutAreas;
};

/** Finds the surface, and where the tissue is cut, by the rules of MeasureTissue(). \param cellAreas by vertex. */
OuterSurface
FindOuterSurface(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<double> & cellAreas,
                 const ImageGrid & grid);

/** The relief of a wall and those next to it that do not face away from it, as behind a crease or an edge; without
 * those that are cut, unless it is cut itself. */
SurfaceRelief
ReliefAround(const OuterSurface & surface, std::size_t wall);

/** The curvatures of the surface about a wall, by the normals of the same walls. */
Curvatures
CurvaturesAround(const OuterSurface & surface, std::size_t wall);
} // namespace tissue

#endif
