/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueMeshEvaluation/SideLabels.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** Of our own meshes. */
constexpr const char * OwnName = "BoundaryLabels";

[[noreturn]] void
Fail(const std::string & path, const std::string & what)
{
  throw std::runtime_error(path + ": " + what);
}

/** VTK's numbers cannot tell larger ones from their neighbours. */
bool
IsLabel(double value)
{
  constexpr double limit = 9007199254740992.0;
  return std::abs(value) < limit && value == std::floor(value);
}

bool
IsWhole(vtkDataArray * array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!IsLabel(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

/** The arrays of a mesh that may be labels: of one or two components, in their order. */
std::vector<vtkDataArray *>
ListArrays(vtkDataSet * mesh, int components)
{
  std::vector<vtkDataArray *> arrays;
  for (int i = 0; i < mesh->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray * const array = mesh->GetCellData()->GetArray(i);
    if (array != nullptr && array->GetName() != nullptr && array->GetNumberOfComponents() == components &&
        array->GetNumberOfTuples() == mesh->GetNumberOfCells())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

/** The names of a mesh's cell arrays with their numbers of components. */
std::string
NameArrays(vtkDataSet * mesh)
{
  std::ostringstream text;
  const int          count = mesh->GetCellData()->GetNumberOfArrays();
  for (int i = 0; i < count; ++i)
  {
    vtkAbstractArray * const array = mesh->GetCellData()->GetAbstractArray(i);
    text << (i > 0 ? ", " : "") << (array->GetName() != nullptr ? array->GetName() : "(no name)") << " of "
         << array->GetNumberOfComponents();
  }
  return count > 0 ? text.str() : "none";
}

/** Whether two names are alike but for their ends, 1 and 2 and so on. */
bool
AreOfTwoSides(const std::string & a, const std::string & b)
{
  if (a.empty() || a.size() != b.size() || a.substr(0, a.size() - 1) != b.substr(0, b.size() - 1))
  {
    return false;
  }
  const std::string ends{ a.back(), b.back() };
  return ends == "12" || ends == "01" || ends == "AB" || ends == "ab";
}

using ArrayPair = std::array<vtkDataArray *, 2>;

/** The only two arrays of the two sides. */
std::optional<ArrayPair>
FindPair(vtkDataSet * mesh)
{
  std::vector<ArrayPair> pairs;
  const auto             arrays = ListArrays(mesh, 1);
  for (vtkDataArray * const a : arrays)
  {
    for (vtkDataArray * const b : arrays)
    {
      if (AreOfTwoSides(a->GetName(), b->GetName()) && IsWhole(a) && IsWhole(b))
      {
        pairs.push_back({ { a, b } });
      }
    }
  }
  return pairs.size() == 1 ? std::optional<ArrayPair>(pairs.front()) : std::nullopt;
}

/** An array of two components is there twice. */
std::optional<ArrayPair>
FindArrays(vtkDataSet * mesh)
{
  const auto twice = [](vtkDataArray * array) { return ArrayPair{ { array, array } }; };
  const auto two = ListArrays(mesh, 2);
  for (vtkDataArray * const array : two)
  {
    if (array->GetName() == std::string("FaceLabels"))
    {
      return twice(array);
    }
  }
  if (two.size() == 1 && IsWhole(two.front()))
  {
    return twice(two.front());
  }
  if (const auto pair = FindPair(mesh))
  {
    return pair;
  }
  for (const char * const name : { "Label", "Labels", "label", "labels", "GroupLabels", "RegionId" })
  {
    for (vtkDataArray * const array : ListArrays(mesh, 1))
    {
      if (array->GetName() == std::string(name))
      {
        return twice(array);
      }
    }
  }
  return std::nullopt;
}

vtkDataArray *
RequireArray(vtkDataSet * mesh, const std::string & name, bool isOneOfTwo, const std::string & path)
{
  vtkDataArray * const array = mesh->GetCellData()->GetArray(name.c_str());
  if (array == nullptr)
  {
    Fail(path, "has no numeric cell array " + name + " (--labelArray); its cell arrays: " + NameArrays(mesh));
  }
  const int components = array->GetNumberOfComponents();
  if (components > 2 || (isOneOfTwo && components > 1))
  {
    Fail(path,
         "array " + name + " has " + std::to_string(components) + " components, must have " +
           (isOneOfTwo ? "1" : "1 or 2"));
  }
  if (array->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    Fail(path,
         "array " + name + " has labels for " + std::to_string(array->GetNumberOfTuples()) + " of the " +
           std::to_string(mesh->GetNumberOfCells()) + " polygons");
  }
  return array;
}

ArrayPair
RequireArrays(vtkDataSet * mesh, const std::string & name, const std::string & path)
{
  if (!name.empty())
  {
    const std::size_t comma = name.find(',');
    const bool        areTwo = comma != std::string::npos;
    return { { RequireArray(mesh, name.substr(0, comma), areTwo, path),
               RequireArray(mesh, areTwo ? name.substr(comma + 1) : name, areTwo, path) } };
  }
  if (mesh->GetCellData()->GetArray(OwnName) != nullptr)
  {
    return RequireArrays(mesh, OwnName, path);
  }
  const auto found = FindArrays(mesh);
  if (!found)
  {
    Fail(
      path,
      "has no labels of the cells on both sides of its polygons: no cell array of two whole numbers (BoundaryLabels, "
      "FaceLabels), no two arrays such as label1 and label2, no array Label of the cell that a polygon belongs to, "
      "no groups with numbers (.obj); its cell arrays: " +
        NameArrays(mesh) + " (--labelArray)");
  }
  return *found;
}
} // namespace

SideLabels
FindSideLabels(vtkDataSet * mesh, const std::string & name, const std::string & path)
{
  const ArrayPair arrays = RequireArrays(mesh, name, path);
  SideLabels      result;
  result.name = arrays[0]->GetName();
  result.areOfBothSides = arrays[0] != arrays[1] || arrays[0]->GetNumberOfComponents() == 2;
  result.labels.resize(static_cast<std::size_t>(mesh->GetNumberOfCells()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    for (int side = 0; side < (result.areOfBothSides ? 2 : 1); ++side)
    {
      const double value = arrays[side]->GetComponent(i, arrays[0] == arrays[1] ? side : 0);
      if (!IsLabel(value))
      {
        std::ostringstream text;
        text << "polygon " << i << " has label " << value << ", labels are whole numbers below 2^53";
        Fail(path, text.str());
      }
      result.labels[static_cast<std::size_t>(i)][static_cast<std::size_t>(side)] = static_cast<Label>(value);
    }
  }
  return result;
}
} // namespace tissue
