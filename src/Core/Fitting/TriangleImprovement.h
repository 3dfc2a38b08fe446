/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TriangleImprovement_h
#define TissueTessellationCore_TriangleImprovement_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief Moves points so that the sum of TriangleDistortion (TriangleQuality.h) over the triangles at each falls. The
 * mesh keeps its triangles.
 *
 * Each sweep moves a point within a wall in the tangent plane there, and a point of a triple line along the chord of
 * its two neighbours on the line; corners stay. A step is the first of 1/4, 1/8 ... 1/64 of the shortest edge at the
 * point by which the sum falls and that turns no triangle by a right angle or more. Where there is none the point
 * stays. A flat wall with straight lines stays flat and its lines straight.
 *
 * The sum is ruled by the worst triangles. Where these cannot be mended, as at an edge between two corners that is much
 * shorter than the others, many sweeps make their neighbours worse, and the mean TriangleQuality can fall.
 *
 * Walls are worked on in parallel, then lines one after the other. `mesh` must have its numberOfCells. */
void
ImproveTriangles(WallMesh & mesh, int sweeps, const Execution & execution = Execution());
} // namespace tissue

#endif
