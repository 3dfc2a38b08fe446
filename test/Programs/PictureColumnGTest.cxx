/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/PictureColumn.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>

#include <cmath>

using namespace tissue;

TEST(PictureColumn, HasTheValuesByVertexAndTheUnit)
{
  std::vector<Cell> cells(4);
  cells[1].label = 5;
  cells[2].label = 7;
  cells[3].label = 9;
  const vtkNew<vtkTypeInt64Array> labels;
  labels->SetName("Label");
  const vtkNew<vtkDoubleArray> curvatures;
  curvatures->SetName("GaussianCurvature");
  const vtkNew<vtkStringArray> names;
  names->SetName("fate");
  for (int i = 0; i < 2; ++i)
  {
    labels->InsertNextValue(9 - 4 * i);
    curvatures->InsertNextValue(0.5 + i);
    names->InsertNextValue(i == 0 ? "sepal" : "petal");
  }
  const vtkNew<vtkTable> table;
  table->AddColumn(labels);
  table->AddColumn(curvatures);
  table->AddColumn(names);

  const auto values = MakePictureValues(table, "GaussianCurvature", cells, "mm");
  ASSERT_TRUE(values);
  EXPECT_EQ("GaussianCurvature (1/mm²)", values->title);
  EXPECT_EQ(1.5, values->numbers.at(1));
  EXPECT_TRUE(std::isnan(values->numbers.at(2)));
  EXPECT_EQ(0.5, values->numbers.at(3));
  const auto texts = MakePictureValues(table, "fate", cells, "mm");
  EXPECT_EQ("fate", texts->title);
  EXPECT_EQ((std::vector<std::string>{ "", "petal", "", "sepal" }), texts->texts);
  EXPECT_FALSE(MakePictureValues(table, "Label", cells, "mm"));
  EXPECT_FALSE(MakePictureValues(table, "other", cells, "mm"));
}
