/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_IndicatorField_h
#define TissueTessellationCore_IndicatorField_h

#include "TissueTessellationCore/Image/LabelVolume.h"

namespace tissue
{
/** \brief The indicators of the cells of a label image, each smoothed by a cubic B-spline of the voxels.
 *
 * At every point the indicators of all cells and the exterior add up to 1. The wall of two cells is where their
 * indicators are equal, without the voxels' staircase; a triple line is where three are equal, a corner where four are.
 */
class IndicatorField
{
public:
  struct Sample
  {
    std::array<double, 4> values = { { 0.0, 0.0, 0.0, 0.0 } };
    /** The gradients along the physical axes. */
    std::array<Point, 4> gradients = {};
  };

  /** The volume must outlive the field. */
  explicit IndicatorField(const LabelVolume & volume);

  /** The indicators of the first `count` cells, at most four, at a physical point. */
  Sample
  Evaluate(const Point & point, const VertexQuadruple & cells, int count) const;

  /** Moves the point to where the indicators of the `count` cells, two to four, are equal, by Gauss-Newton steps of
   * least length. Returns false, and leaves the point as it was, where one of the cells is not near or the point would
   * move by more than `reach` voxels. */
  bool
  Project(Point & point, const VertexQuadruple & cells, int count, double reach) const;

  /** The direction of the triple line of three cells: seen from its tip they come counterclockwise. It is not
   * normalized, and zero where one of the cells is not near. */
  Point
  LineDirection(const Point & point, const VertexTriple & cells) const;

  /** The length of a physical vector in voxels. */
  double
  LengthInVoxels(const Point & vector) const;

private:
  /** The vertices of four voxels along the first axis. */
  using Row = std::array<VertexId, 4>;

  /** Whether the 4 x 4 x 4 voxels from this one on are all in the image. */
  bool
  IsWithin(int x, int y, int z) const;
  /** The row from this voxel on, which must be in the image. */
  Row
  RowWithin(int x, int y, int z) const;
  /** The row from this voxel on, be it in the image or not. */
  Row
  RowAt(int x, int y, int z) const;

  const LabelVolume &  m_Volume;
  std::array<Point, 3> m_Inverse;
};
} // namespace tissue

#endif
