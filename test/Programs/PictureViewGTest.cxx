/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/PictureView.h"
#include "VoxelWallMesh.h"

#include <gtest/gtest.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace
{
using tissue::Vector;

double
Dot(const Vector & a, const Vector & b)
{
  return vtkMath::Dot(a.data(), b.data());
}

/** The half of the unit ball on one side of the origin along an axis: a block of voxels whose points are drawn in. */
tissue::WallMesh
MakeHalfBall(int axis, int sign)
{
  tissue::WallMesh mesh = MakeVoxelWallMesh({ { 4, 4, 4 } }, std::vector<tissue::VertexId>(64, 1));
  for (tissue::Point & point : mesh.points)
  {
    double maximum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      point[i] = i == axis ? sign * point[i] / 4.0 : (point[i] - 2.0) / 2.0;
      maximum = std::max(maximum, std::abs(point[i]));
    }
    const double length = std::sqrt(Dot(point, point));
    for (double & coordinate : point)
    {
      coordinate *= length > 0.0 ? maximum / length : 1.0;
    }
  }
  for (auto & triangle : mesh.triangles)
  {
    if (sign < 0)
    {
      std::swap(triangle[1], triangle[2]); // mirrored
    }
  }
  return mesh;
}

Vector
CenterOfHalfBall(int axis, int sign)
{
  Vector center{};
  center[axis] = sign * 3.0 / 8.0;
  return center;
}
} // namespace

TEST(PictureView, TheRoundTipOfTheTissueIsUp)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int sign : { -1, 1 })
    {
      const auto view =
        tissue::ChooseView(MakeHalfBall(axis, sign), std::vector<tissue::Cell>(2), CenterOfHalfBall(axis, sign));
      EXPECT_GT(sign * view.axes[1][axis], 0.5);
      EXPECT_GT(sign * view.axes[2][axis], 0.3);
      EXPECT_NEAR(view.axes[0][axis], 0.0, 1e-12);
      for (int i = 0; i < 3; ++i)
      {
        EXPECT_NEAR(Dot(view.axes[i], view.axes[i]), 1.0, 1e-12);
        EXPECT_NEAR(Dot(view.axes[i], view.axes[(i + 1) % 3]), 0.0, 1e-12);
      }
    }
  }
}

TEST(PictureView, DrawingsAreSideBySideAroundTheOrigin)
{
  tissue::PictureView view;
  view.axes = { { { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 0 } } } };
  const tissue::ViewBox left{ { { 10, 0, 0 } }, { { 12, 4, 1 } } };
  const tissue::ViewBox right{ { { 20, 6, 0 } }, { { 28, 8, 3 } } };
  const auto            layout = tissue::PlaceSideBySide(view, left, right);
  // 2 + 8 wide, and a gap of 6 % of that.
  EXPECT_NEAR(layout.size[0], 10.6, 1e-12);
  EXPECT_EQ(layout.size[1], 4.0);
  EXPECT_EQ(layout.size[2], 3.0);
  EXPECT_NEAR(left.low[0] + layout.leftPosition[1], -5.3, 1e-12);
  EXPECT_NEAR(right.high[0] + layout.rightPosition[1], 5.3, 1e-12);
  EXPECT_EQ(layout.leftPosition[2], -2.0);
  EXPECT_EQ(layout.rightPosition[2], -7.0);
  EXPECT_EQ(layout.leftPosition[0], -0.5);
  EXPECT_EQ(layout.rightPosition[0], -1.5);
}

TEST(PictureView, TheBoxIsAlongTheAxesOfTheView)
{
  tissue::PictureView view;
  view.axes = { { { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 0 } } } };
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  points->InsertNextPoint(5, 4, -3);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  const auto box = tissue::FindBox(view, data);
  EXPECT_EQ(box.low, (Vector{ { 2, -3, 1 } }));
  EXPECT_EQ(box.high, (Vector{ { 4, 3, 5 } }));
  EXPECT_EQ(box.Size(1), 6.0);
}
