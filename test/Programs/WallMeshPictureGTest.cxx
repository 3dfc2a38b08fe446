/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"
#include "Shared/Pictures/PictureObstacle.h"
#include "Shared/Pictures/WallMeshPicture.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

using WallMeshPictureTest = TemporaryFolderTest;

TEST_F(WallMeshPictureTest, ShowsTheCellsOnWhiteAndTwiceTheSame)
{
  const std::string obstacle = tissue::FindPictureObstacle();
  if (!obstacle.empty())
  {
    GTEST_SKIP() << obstacle;
  }
  const FourCubes                tissue;
  tissue::WallMeshPictureOptions options;
  options.width = 320;
  options.height = 180;
  const std::string first = PathOf("first.png");
  const std::string second = PathOf("second.png");
  tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, first, options);
  tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, second, options);
  EXPECT_EQ(ReadBytes(first), ReadBytes(second));

  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(first.c_str());
  reader->Update();
  vtkImageData * image = reader->GetOutput();
  ASSERT_EQ(image->GetDimensions()[0], 320);
  ASSERT_EQ(image->GetDimensions()[1], 180);
  const auto isWhite = [image](int x, int y) {
    const auto * pixel = static_cast<const unsigned char *>(image->GetScalarPointer(x, y, 0));
    return pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255;
  };
  const auto countInk = [&](int fromX, int toX, int fromY, int toY) {
    int count = 0;
    for (int y = fromY; y < toY; ++y)
    {
      for (int x = fromX; x < toX; ++x)
      {
        count += isWhite(x, y) ? 0 : 1;
      }
    }
    return count;
  };
  EXPECT_TRUE(isWhite(0, 0));
  EXPECT_TRUE(isWhite(319, 179));
  // The tissue cut open is on the left, the larger one that is drawn apart on the right.
  EXPECT_GT(countInk(0, 140, 40, 180), 2000);
  EXPECT_GT(countInk(180, 320, 0, 180), countInk(0, 140, 40, 180));
}

TEST_F(WallMeshPictureTest, WhatCannotBeDrawnIsRefused)
{
  if (!tissue::FindPictureObstacle().empty())
  {
    GTEST_SKIP() << tissue::FindPictureObstacle();
  }
  const FourCubes                tissue;
  tissue::WallMeshPictureOptions options;
  options.height = 63;
  const std::string path = PathOf("refused.png");
  EXPECT_THROW(tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, path, options), std::runtime_error);
  EXPECT_THROW(tissue::WriteWallMeshPicture(tissue::WallMesh(), tissue.cells, path), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(path));
}

#ifdef __linux__
TEST_F(WallMeshPictureTest, WithoutADisplayItSaysWhatToDo)
{
  const char *      display = std::getenv("DISPLAY");
  const std::string before = display ? display : "";
  setenv("DISPLAY", ":4711", 1);
  EXPECT_NE(tissue::FindPictureObstacle().find("':4711' (DISPLAY) cannot be opened"), std::string::npos);
  EXPECT_NE(tissue::FindPictureObstacle().find("xvfb-run -a"), std::string::npos);
  const FourCubes tissue;
  EXPECT_THROW(tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, PathOf("none.png")), std::runtime_error);
  display ? setenv("DISPLAY", before.c_str(), 1) : unsetenv("DISPLAY");
}
#endif
