/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueMeshEvaluation/MeshFile.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetReader.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkObject.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <vector>

namespace tissue
{
namespace
{
template <typename TReader>
vtkSmartPointer<vtkDataSet>
ReadBy(const std::string & path)
{
  const vtkNew<TReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput() == nullptr)
  {
    throw std::runtime_error(path + ": is damaged or cut off");
  }
  return reader->GetOutput();
}

/** Of each line that begins a group the whole numbers in its name. */
std::vector<std::vector<long long>>
ReadGroupNumbers(const std::string & path)
{
  static const std::regex             number(R"((^|[^0-9])(-?[0-9]{1,18}))");
  std::vector<std::vector<long long>> groups;
  std::ifstream                       stream(path);
  for (std::string line; std::getline(stream, line);)
  {
    if (line.rfind("g ", 0) == 0 || line.rfind("g\t", 0) == 0 || line == "g")
    {
      groups.emplace_back();
      const std::string name = line.substr(1);
      for (auto at = std::sregex_iterator(name.begin(), name.end(), number); at != std::sregex_iterator(); ++at)
      {
        groups.back().push_back(std::stoll((*at)[2]));
      }
    }
  }
  return groups;
}

/** Adds the array of the groups' labels, where each group of a cell has as many, one or two. */
void
AddGroupLabels(const std::string & path, vtkDataSet * mesh)
{
  vtkDataArray * const ids = mesh->GetCellData()->GetArray("GroupIds");
  const auto           groups = ReadGroupNumbers(path);
  if (ids == nullptr || groups.empty())
  {
    return;
  }
  const int  components = static_cast<int>(groups.front().size());
  const bool isAlike = std::all_of(groups.begin(), groups.end(), [components](const auto & group) {
    return static_cast<int>(group.size()) == components;
  });
  if (!isAlike || components < 1 || components > 2)
  {
    return;
  }
  const vtkNew<vtkLongLongArray> labels;
  labels->SetName("GroupLabels");
  labels->SetNumberOfComponents(components);
  labels->SetNumberOfTuples(ids->GetNumberOfTuples());
  for (vtkIdType cell = 0; cell < ids->GetNumberOfTuples(); ++cell)
  {
    const double id = ids->GetComponent(cell, 0);
    if (!(id >= 0.0 && id < static_cast<double>(groups.size())))
    {
      return;
    }
    for (int i = 0; i < components; ++i)
    {
      labels->SetTypedComponent(cell, i, groups[static_cast<std::size_t>(id)][static_cast<std::size_t>(i)]);
    }
  }
  mesh->GetCellData()->AddArray(labels);
}
} // namespace

vtkSmartPointer<vtkDataSet>
ReadMeshFile(const std::string & path)
{
  if (!std::ifstream(path))
  {
    throw std::runtime_error(path + ": there is no such file, or it cannot be read");
  }
  // What is wrong is said in one line.
  vtkObject::GlobalWarningDisplayOff();
  if (vtkNew<vtkXMLPolyDataReader>()->CanReadFile(path.c_str()) != 0)
  {
    return ReadBy<vtkXMLPolyDataReader>(path);
  }
  if (vtkNew<vtkXMLUnstructuredGridReader>()->CanReadFile(path.c_str()) != 0)
  {
    return ReadBy<vtkXMLUnstructuredGridReader>(path);
  }
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(
    extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (extension == ".ply" && vtkPLYReader::CanReadFile(path.c_str()) != 0)
  {
    return ReadBy<vtkPLYReader>(path);
  }
  if (extension == ".stl")
  {
    return ReadBy<vtkSTLReader>(path);
  }
  if (extension == ".obj")
  {
    auto mesh = ReadBy<vtkOBJReader>(path);
    AddGroupLabels(path, mesh);
    return mesh;
  }
  const vtkNew<vtkDataSetReader> legacy;
  legacy->SetFileName(path.c_str());
  if (legacy->IsFilePolyData() == 0 && legacy->IsFileUnstructuredGrid() == 0)
  {
    throw std::runtime_error(path + ": is no mesh in a format that is read: .vtp, .vtu, .vtk (POLYDATA or "
                                    "UNSTRUCTURED_GRID), .ply, .stl, .obj");
  }
  return ReadBy<vtkDataSetReader>(path);
}
} // namespace tissue
