/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CornerFitting_h
#define TissueTessellationCore_CornerFitting_h

#include "Complex/AdjacencyComplex.h"
#include "Image/IndicatorField.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <vector>

namespace tissue
{
/** \brief Fits the corners of ComputeCorners() to the image more finely than its voxels.
 *
 * Each corner goes from its junction to where the indicators of its four cells are equal. Then corners are moved apart
 * so that every triple line is at least a voxel long and runs from its one corner to the other as it does in the image.
 * Corners of cells that have no junction in the image stay at the mean of the neighbouring corners.
 *
 * The corners are in the order of AdjacencyComplex::GetTetrahedra(). `unfitted`, where given, lists those that have no
 * junction, or whose cells' indicators are nowhere equal within three voxels of it. */
std::vector<Point>
FitCorners(const AdjacencyComplex & complex, const JunctionSet & junctions, const IndicatorField & field,
           std::vector<std::size_t> * unfitted = nullptr);
} // namespace tissue

#endif
