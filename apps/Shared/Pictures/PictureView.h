/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PictureView_h
#define PictureView_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Geometry/Vector.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <array>
#include <vector>

class vtkPolyData;

namespace tissue
{
using Vector = Point;

/** a + factor * b */
inline Vector
Combine(const Vector & a, double factor, const Vector & b)
{
  return a + factor * b;
}

/** The directions of a picture, unit vectors of the physical space. */
struct PictureView
{
  /** To the right, upwards and to the viewer; orthogonal. */
  std::array<Vector, 3> axes;
  /** The two horizontal axes of the tissue between which the viewer stands. */
  std::array<Vector, 2> sides;
};

/** \brief A view from obliquely above, with the tissue upright.
 *
 * The tissue's axis is the axis of space that its rounded tip points to, as its free surface tells; `center` is the
 * centre of the tissue. */
PictureView
ChooseView(const WallMesh & mesh, const std::vector<Cell> & cells, const Point & center);

/** A box along the axes of a view. */
struct ViewBox
{
  Vector low;
  Vector high;

  double
  Size(int axis) const
  {
    return high[axis] - low[axis];
  }
};

/** The box around the points of some data; there is at least one. */
ViewBox
FindBox(const PictureView & view, vtkPolyData * data);

/** Two drawings side by side, both centred on the same height and depth, the whole on the origin. */
struct PictureLayout
{
  Vector leftPosition;
  Vector rightPosition;
  /** Along the axes of the view. */
  Vector size;
};

PictureLayout
PlaceSideBySide(const PictureView & view, const ViewBox & left, const ViewBox & right);
} // namespace tissue

#endif
