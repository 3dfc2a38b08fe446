/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LineSubdivision_h
#define TissueTessellationCore_LineSubdivision_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief Cuts each triple line into NumberOfSegments() pieces of equal length for its EdgeLengthAt()
 * (WallEdgeLengths.h), and the triangles at it with it; lines with both ends in common into two at least, or they were
 * one. Corners stay, and points within walls do.
 *
 * A line that was in one piece, as a star's are, is cut where it lies. A line that was cut before gets or loses points,
 * and its points slide along the polygon that it was. Where that would turn a triangle of its walls over or flatten it,
 * a point stays or slides less far. The walls stay joined, disks, and in their order. The points of lines and corners
 * come first, the old ones in their order.
 *
 * \throws std::invalid_argument unless there is one length for each wall, and the triangles of a wall are consecutive.
 */
void
SubdivideLines(WallMesh & mesh, const std::vector<double> & edgeLengths);
} // namespace tissue

#endif
