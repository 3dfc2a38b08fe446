/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKArrays_h
#define TissueTessellationVTKArrays_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Statistics/TissueStatistics.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTypeFloat64Array.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt8Array.h>

#include <numeric>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace tissue
{
/** The helpers that the parts of the VTK bridge share. */
namespace bridge
{
/** The type of the arrays of labels. It has 64 bits, as no narrower type holds every label. */
using LabelArray = vtkTypeInt64Array;

template <typename TArray>
vtkSmartPointer<TArray>
MakeArray(const char * name, int numberOfComponents, vtkIdType numberOfTuples)
{
  vtkSmartPointer<TArray> array = vtkSmartPointer<TArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(numberOfComponents);
  array->SetNumberOfTuples(numberOfTuples);
  return array;
}

/** Adds an array with one value for each of the given vertices, walls or other numbers. */
template <typename TArray, typename TNumber, typename TValueOf>
void
AddColumn(vtkFieldData * attributes, const char * name, const std::vector<TNumber> & numbers, const TValueOf & valueOf)
{
  const auto column = MakeArray<TArray>(name, 1, static_cast<vtkIdType>(numbers.size()));
  for (std::size_t row = 0; row < numbers.size(); ++row)
  {
    column->SetValue(static_cast<vtkIdType>(row), valueOf(numbers[row]));
  }
  attributes->AddArray(column);
}

/** The array that holds numbers of a type. */
template <typename TNumber>
struct ArrayOf;
template <>
struct ArrayOf<std::uint8_t>
{
  using Type = vtkTypeUInt8Array;
};
template <>
struct ArrayOf<std::int32_t>
{
  using Type = vtkTypeInt32Array;
};
template <>
struct ArrayOf<std::int64_t>
{
  using Type = vtkTypeInt64Array;
};
template <>
struct ArrayOf<double>
{
  using Type = vtkTypeFloat64Array;
};

/** Adds a column as an array with those of its rows that are given, in their order. The components of vectors are named
 * X, Y and Z. */
inline void
AddColumn(vtkFieldData * attributes, const StatisticColumn & column, const std::vector<std::int32_t> & rows)
{
  const int components = column.numberOfComponents;
  std::visit(
    [&](const auto & values) {
      using Number = typename std::decay_t<decltype(values)>::value_type;
      const auto array =
        MakeArray<typename ArrayOf<Number>::Type>(column.name.c_str(), components, static_cast<vtkIdType>(rows.size()));
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const auto first = static_cast<std::size_t>(components) * static_cast<std::size_t>(rows[i]);
        for (int c = 0; c < components; ++c)
        {
          array->SetTypedComponent(static_cast<vtkIdType>(i), c, values[first + static_cast<std::size_t>(c)]);
        }
      }
      for (int axis = 0; components == 3 && axis < 3; ++axis)
      {
        const char * const names[] = { "X", "Y", "Z" };
        array->SetComponentName(axis, names[axis]);
      }
      attributes->AddArray(array);
    },
    column.values);
}

/** first, first + 1, ... end - 1. */
inline std::vector<std::int32_t>
NumbersOf(std::int32_t first, std::size_t end)
{
  std::vector<std::int32_t> numbers(end < static_cast<std::size_t>(first) ? 0 : end - first);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

/** Makes points of double precision, all of which the caller must set. */
inline vtkSmartPointer<vtkPoints>
MakePoints(vtkIdType numberOfPoints)
{
  vtkSmartPointer<vtkPoints> points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(numberOfPoints);
  return points;
}

/** Says that the coordinates are those of ITK: x to the left, y to the posterior, z to the superior. */
inline void
AddCoordinateSystem(vtkDataObject * data)
{
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("LPS");
  data->GetFieldData()->AddArray(space);
}

/** Throws std::invalid_argument, which names the owner, where a vertex is none of the cells'. */
inline void
RequireVertex(VertexId vertex, const std::vector<Cell> & cells, const char * owner, std::size_t ownerIndex)
{
  if (vertex < 0 || static_cast<std::size_t>(vertex) >= cells.size())
  {
    throw std::invalid_argument(std::string("VTK bridge: a cell of ") + owner + " " + std::to_string(ownerIndex) +
                                " is " + std::to_string(vertex) + ", must be at least 0 and below " +
                                std::to_string(cells.size()));
  }
}
} // namespace bridge
} // namespace tissue

#endif
