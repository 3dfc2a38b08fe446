/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TableFromLists_h
#define TableFromLists_h

#include <vtkNew.h>
#include <vtkTable.h>

#include <initializer_list>

/** Adds a column of values to a table. */
template <typename TArray, typename TValue>
void
AddColumn(vtkTable * table, const char * name, std::initializer_list<TValue> values)
{
  vtkNew<TArray> array;
  array->SetName(name);
  for (const TValue & value : values)
  {
    array->InsertNextValue(value);
  }
  table->AddColumn(array);
}

#endif
