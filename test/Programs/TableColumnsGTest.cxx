/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/TableColumns.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTypeFloat64Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt8Array.h>

#include <limits>

TEST(TableColumns, AreTheComponentsOfTheArraysWithTheirValuesAsText)
{
  vtkNew<vtkTypeInt64Array> labels;
  labels->SetName("Label");
  labels->InsertNextValue((std::int64_t(1) << 53) + 1); // has no double
  labels->InsertNextValue(-7);
  vtkNew<vtkTypeUInt8Array> flags;
  flags->SetName("IsClosed");
  flags->InsertNextValue(1);
  flags->InsertNextValue(0);
  vtkNew<vtkTypeFloat64Array> axis;
  axis->SetName("Axis");
  axis->SetNumberOfComponents(2);
  axis->SetComponentName(0, "X");
  axis->SetComponentName(1, "Y");
  axis->InsertNextTuple2(0.1, std::numeric_limits<double>::quiet_NaN());
  axis->InsertNextTuple2(1e300, -2.0);
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  names->InsertNextValue("a, b");
  names->InsertNextValue("");
  vtkNew<vtkTable> table;
  table->AddColumn(labels);
  table->AddColumn(flags);
  table->AddColumn(axis);
  table->AddColumn(names);

  const auto  columns = tissue::ListColumns(table);
  std::string rows[2];
  std::string header;
  for (const auto & column : columns)
  {
    header += column.name + "|";
    rows[0] += tissue::ToText(column, 0) + "|";
    rows[1] += tissue::ToText(column, 1) + "|";
  }
  EXPECT_EQ(header, "Label|IsClosed|AxisX|AxisY|Name|");
  EXPECT_EQ(rows[0], "9007199254740993|1|0.1||a, b|");
  EXPECT_EQ(rows[1], "-7|0|1e+300|-2||");
  EXPECT_EQ(tissue::TypeOf(columns[0]), tissue::ValueType::WholeNumber);
  EXPECT_EQ(tissue::TypeOf(columns[1]), tissue::ValueType::WholeNumber);
  EXPECT_EQ(tissue::TypeOf(columns[3]), tissue::ValueType::Number);
  EXPECT_EQ(tissue::TypeOf(columns[4]), tissue::ValueType::Text);
}
