/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TriangleOrientation_h
#define TriangleOrientation_h

#include "TissueTessellationCore/Evaluation/LabelledTriangles.h"

#include <set>
#include <string>
#include <vector>

namespace tissue
{
/** \brief Turns triangles so that their normals point from the first label to the second, where a mesh has other rules.
 *
 * Triangles of a cell that share an edge no third one has must run along it in opposite directions, seen from within.
 * Where more than a tenth of such pairs do not, the sides of the triangles mean nothing, as of faces of voxels that all
 * point along the axes: triangles are turned until all of a connected part agree, and the cells there have positive
 * volumes. A few such pairs are faults of the mesh and stay. Where all agree, but the cells' volumes are negative, the
 * normals point from the second label to the first.
 *
 * \param places the first point at the place of each. \param exterior labels that are no cells.
 * \returns a warning of what was turned, or nothing. */
std::vector<std::string>
OrientByLabels(TrianglesOfLabels & mesh, const std::vector<PointId> & places, const std::set<Label> & exterior);
} // namespace tissue

#endif
