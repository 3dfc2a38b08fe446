/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SolidMoments_h
#define TissueTessellationCore_SolidMoments_h

#include "TissueTessellationCore/Geometry/Metric.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The moments of what the closed surface of a cell holds. */
struct SolidMoments
{
  double area = 0.0;
  double volume = 0.0;
  Point  centroid = { { 0.0, 0.0, 0.0 } };
  /** About the centroid, over the volume. */
  Metric covariance = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
};

/** Measures all cells, by vertex; that of the exterior is empty, and without volume there is neither centroid nor
 * covariance. */
std::vector<SolidMoments>
MeasureSolids(const WallMesh & mesh, std::size_t numberOfVertices);
} // namespace tissue

#endif
