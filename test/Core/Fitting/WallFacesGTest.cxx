/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Fitting/WallFaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using namespace tissue;

/** Two cells that meet at x = 1.5 on both sides of a gap in y, which the exterior fills. */
LabelVolume
TwoCellsWithAGap()
{
  LabelVolume volume;
  volume.size = { { 4, 9, 2 } };
  for (int i = 0; i < 4 * 9 * 2; ++i)
  {
    const int x = i % 4;
    const int y = i / 4 % 9;
    volume.vertices.push_back(y == 4 ? 0 : x < 2 ? 1 : 2);
  }
  return volume;
}

/** A wall of one triangle at each of the places of y. */
WallMesh
WallsAt(const std::vector<double> & places)
{
  WallMesh mesh;
  for (const double y : places)
  {
    const auto first = static_cast<PointId>(mesh.points.size());
    mesh.triangles.push_back({ { first, first + 1, first + 2 } });
    mesh.wallOfTriangle.push_back(static_cast<WallId>(mesh.walls.size()));
    mesh.walls.push_back({ { { 1, 2 } } });
    for (const double along : { -0.5, 0.0, 0.5 })
    {
      mesh.points.push_back({ { 1.5, y + along, 0.5 } });
      mesh.numberOfCells.push_back(CellsAtCorner);
    }
  }
  return mesh;
}

/** The least and the largest y of a wall's faces. */
std::array<float, 2>
RangeOf(const ImagePlaces & faces, std::size_t wall)
{
  const auto byY = [](const ImagePlaces::Place & a, const ImagePlaces::Place & b) { return a[1] < b[1]; };
  const auto range = std::minmax_element(faces.Begin(wall), faces.End(wall), byY);
  return { { (*range.first)[1], (*range.second)[1] } };
}
} // namespace

TEST(WallFaces, EachOfSeveralWallsHasThePieceAtItsOutline)
{
  const WallMesh    mesh = WallsAt({ 6.0, 2.0 });
  const ImagePlaces faces = CollectWallFaces(mesh, CellsOfWalls(mesh), TwoCellsWithAGap());
  EXPECT_EQ(faces.End(0) - faces.Begin(0), 8);
  EXPECT_EQ(RangeOf(faces, 0), (std::array<float, 2>{ { 5.0f, 8.0f } }));
  EXPECT_EQ(RangeOf(faces, 1), (std::array<float, 2>{ { 0.0f, 3.0f } }));
}

TEST(WallFaces, WallsAtOnePieceShareItAndOthersGoToTheNearest)
{
  const WallMesh    mesh = WallsAt({ 0.0, 2.6 });
  const ImagePlaces faces = CollectWallFaces(mesh, CellsOfWalls(mesh), TwoCellsWithAGap());
  EXPECT_EQ(RangeOf(faces, 0), (std::array<float, 2>{ { 0.0f, 1.0f } }));
  EXPECT_EQ(RangeOf(faces, 1), (std::array<float, 2>{ { 2.0f, 8.0f } })) << "with the piece beyond the gap";
}

TEST(WallFaces, TheOnlyWallHasAllPieces)
{
  const WallMesh    mesh = WallsAt({ 2.0 });
  const ImagePlaces faces = CollectWallFaces(mesh, { { { 2, 1 } } }, TwoCellsWithAGap());
  EXPECT_EQ(faces.End(0) - faces.Begin(0), 16);
}
