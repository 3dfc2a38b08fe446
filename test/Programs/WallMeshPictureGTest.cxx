/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FourCubes.h"
#include "Shared/Pictures/OffScreenWindow.h"
#include "Shared/Pictures/PictureObstacle.h"
#include "Shared/Pictures/WallMeshPicture.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
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

TEST_F(WallMeshPictureTest, ValuesHaveTheirColorsAndALegend)
{
  if (!tissue::FindPictureObstacle().empty())
  {
    GTEST_SKIP() << tissue::FindPictureObstacle();
  }
  const FourCubes                tissue;
  tissue::WallMeshPictureOptions options;
  options.values = tissue::PictureValues{ "rate", { 0.0, 0.25, 0.5, 0.75, std::nan("") }, {} };
  options.width = 640;
  options.height = 360;
  const std::string path = PathOf("values.png");
  tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, path, options);
  const vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto countLike = [&reader](int red, int green, int blue, int firstRow, int lastRow) {
    int count = 0;
    for (int y = firstRow; y < lastRow; ++y)
    {
      for (int x = 0; x < 640; ++x)
      {
        const auto * const pixel = static_cast<unsigned char *>(reader->GetOutput()->GetScalarPointer(x, y, 0));
        count += std::abs(pixel[0] - red) < 12 && std::abs(pixel[1] - green) < 12 && std::abs(pixel[2] - blue) < 12;
      }
    }
    return count;
  };
  // The legend, from the dark end to the light one, and the grey of what is not known, below the cells.
  EXPECT_GT(countLike(72, 20, 95, 0, 60), 20);
  EXPECT_GT(countLike(33, 145, 140, 0, 60), 20);
  EXPECT_GT(countLike(245, 230, 37, 0, 60), 20);
  EXPECT_GT(countLike(178, 178, 178, 0, 60), 20);

  options.values->numbers.pop_back();
  EXPECT_THROW(tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, path, options), std::invalid_argument);
}

#ifdef __linux__
TEST_F(WallMeshPictureTest, WithoutADisplayItIsDrawnAllTheSameOrSaysWhatToDo)
{
  const char *      display = std::getenv("DISPLAY");
  const std::string before = display ? display : "";
  setenv("DISPLAY", ":4711", 1);
  EXPECT_NE(tissue::FindDisplayObstacle().find("':4711' (DISPLAY) cannot be opened"), std::string::npos);
  EXPECT_NE(tissue::FindDisplayObstacle().find("xvfb-run -a"), std::string::npos);
  const FourCubes   tissue;
  const std::string path = PathOf("none.png");
  if (tissue::FindSurfacelessObstacle().empty())
  {
    EXPECT_EQ(tissue::FindPictureObstacle(), "");
    tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, path);
    const vtkNew<vtkPNGReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    std::set<std::array<unsigned char, 3>> colors;
    for (int x = 0; x < 1600; ++x)
    {
      const auto * const pixel = static_cast<unsigned char *>(reader->GetOutput()->GetScalarPointer(x, 450, 0));
      colors.insert({ { pixel[0], pixel[1], pixel[2] } });
    }
    EXPECT_GT(colors.size(), 20u);
  }
  else
  {
    EXPECT_NE(tissue::FindPictureObstacle().find(tissue::FindSurfacelessObstacle()), std::string::npos);
    EXPECT_THROW(tissue::WriteWallMeshPicture(tissue.mesh, tissue.cells, path), std::runtime_error);
  }
  display ? setenv("DISPLAY", before.c_str(), 1) : unsetenv("DISPLAY");
}
#endif
