/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WallMeshReader_h
#define WallMeshReader_h

#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"

#include <string>
#include <vector>

namespace tissue
{
/** A wall mesh that was read, and what is to be said of it. */
struct WallMeshFile
{
  TrianglesOfLabels        mesh;
  std::vector<std::string> warnings;
};

/** \brief Reads a wall mesh of any origin that VTK reads (MeshFile.h), with labels in its cell arrays (SideLabels.h).
 *
 * Polygons become triangles, whose normals point from the first label to the second (TriangleOrientation.h). Where each
 * has one label, they are the
 * surfaces of the cells one after the other: two polygons of the same places and different labels are a wall, one
 * without a partner is at the exterior. Three-dimensional cells (tetrahedra, polyhedra) with a label are taken for
 * their faces; faces within a label are left out. The exterior's label is -1 there, as in other programs.
 * Lines and vertices are left out.
 *
 * \param labelArray see FindSideLabels(). \param exteriorLabels those of the image.
 * \throws std::runtime_error: as MeshFile.h and SideLabels.h; no polygon; cells of which no two share a polygon. */
WallMeshFile
ReadWallMesh(const std::string & path, const std::string & labelArray, const std::vector<Label> & exteriorLabels);
} // namespace tissue

#endif
