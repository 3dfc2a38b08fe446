/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PeerMeshers.h"

#include <vtkCellData.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkDiscreteMarchingCubes.h>
#include <vtkImageData.h>
#include <vtkMergePoints.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <map>

namespace tissue
{
namespace
{
vtkSmartPointer<vtkImageData>
ShareImage(const CellImage * image)
{
  const auto size = image->GetBufferedRegion().GetSize();
  const auto share = vtkSmartPointer<vtkImageData>::New();
  share->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), static_cast<int>(size[2]));
  share->SetSpacing(image->GetSpacing().GetDataPointer());
  vtkNew<vtkTypeInt32Array> values;
  constexpr int             keepWithOwner = 1; // VTK's array must not free the image's buffer.
  values->SetArray(const_cast<VertexId *>(image->GetBufferPointer()),
                   static_cast<vtkIdType>(image->GetBufferedRegion().GetNumberOfPixels()),
                   keepWithOwner);
  share->GetPointData()->SetScalars(values);
  return share;
}

template <typename TContourFilter>
vtkSmartPointer<vtkPolyData>
Contour(const CellImage * image, VertexId numberOfVertices)
{
  vtkNew<TContourFilter> filter;
  filter->SetInputData(ShareImage(image));
  filter->GenerateValues(numberOfVertices - 1, ExteriorVertex + 1, numberOfVertices - 1);
  filter->ComputeNormalsOff();
  filter->ComputeGradientsOff();
  filter->Update();
  return filter->GetOutput();
}

/** A triangle of one cell's contour; its normal points out of the cell. */
struct OneSidedTriangle
{
  std::array<PointId, 3> points;
  VertexId               cell;
};

/** Reads the triangles of the contours, and fills `points` with their points.
 *
 * Points at the same place are merged first, as each cell has its own. A triangle's cell is its scalar, or that of its
 * points where the filter gives only those. */
std::vector<OneSidedTriangle>
ReadContours(vtkPolyData * contours, std::vector<Point> & points)
{
  vtkDataArray * const cellLabels = contours->GetCellData()->GetScalars();
  vtkDataArray * const pointLabels = contours->GetPointData()->GetScalars();
  vtkNew<vtkPoints>    merged;
  merged->SetDataTypeToDouble();
  vtkNew<vtkMergePoints> locator;
  locator->InitPointInsertion(merged, contours->GetBounds(), contours->GetNumberOfPoints());
  std::vector<PointId> mergedIds(contours->GetNumberOfPoints());
  for (vtkIdType p = 0; p < contours->GetNumberOfPoints(); ++p)
  {
    vtkIdType id = 0;
    locator->InsertUniquePoint(contours->GetPoint(p), id);
    mergedIds[p] = static_cast<PointId>(id);
  }
  points.resize(merged->GetNumberOfPoints());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    merged->GetPoint(static_cast<vtkIdType>(p), points[p].data());
  }

  std::vector<OneSidedTriangle> triangles;
  triangles.reserve(contours->GetNumberOfCells());
  for (vtkIdType t = 0; t < contours->GetNumberOfCells(); ++t)
  {
    vtkIdType         numberOfPoints = 0;
    const vtkIdType * ids = nullptr;
    contours->GetCellPoints(t, numberOfPoints, ids);
    const double label = cellLabels ? cellLabels->GetTuple1(t) : pointLabels->GetTuple1(ids[0]);
    triangles.push_back(
      { { { mergedIds[ids[0]], mergedIds[ids[1]], mergedIds[ids[2]] } }, static_cast<VertexId>(label) });
  }
  return triangles;
}

/** What stands for several cells where a vertex stands for one; vertices are 0 or more. */
constexpr VertexId SeveralCells = -1;

/** Finds for each point the only cell that has it, or SeveralCells. */
std::vector<VertexId>
FindOnlyCells(const std::vector<OneSidedTriangle> & triangles, std::size_t numberOfPoints)
{
  std::vector<VertexId> only(numberOfPoints, ExteriorVertex);
  for (const OneSidedTriangle & triangle : triangles)
  {
    for (const PointId p : triangle.points)
    {
      only[p] = only[p] == ExteriorVertex || only[p] == triangle.cell ? triangle.cell : SeveralCells;
    }
  }
  return only;
}

/** Joins each two triangles of the same points to one between their cells. A triangle without such a partner has the
 * exterior behind it if no other cell has its points, and a gap otherwise. */
std::vector<LabelledTriangles::Triangle>
JoinSides(const std::vector<OneSidedTriangle> & triangles, std::size_t numberOfPoints, VertexId gap)
{
  const std::vector<VertexId> only = FindOnlyCells(triangles, numberOfPoints);
  const auto                  corners = [](const OneSidedTriangle & triangle) {
    std::array<PointId, 3> sorted = triangle.points;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  std::map<std::array<PointId, 3>, std::size_t> unmatched;
  std::vector<LabelledTriangles::Triangle>      joined;
  for (const OneSidedTriangle & triangle : triangles)
  {
    const auto [found, isNew] = unmatched.emplace(corners(triangle), joined.size());
    if (isNew)
    {
      const bool isAtExterior = std::all_of(
        triangle.points.begin(), triangle.points.end(), [&](PointId p) { return only[p] == triangle.cell; });
      joined.push_back({ triangle.points, { { triangle.cell, isAtExterior ? ExteriorVertex : gap } } });
    }
    else
    {
      joined[found->second].cells[1] = triangle.cell;
      unmatched.erase(found);
    }
  }
  return joined;
}
} // namespace

PeerMesh
MeshByLabelContours(const CellImage * image, VertexId numberOfVertices, LabelContour method)
{
  Stopwatch  stopwatch;
  const auto contours = method == LabelContour::DiscreteMarchingCubes
                          ? Contour<vtkDiscreteMarchingCubes>(image, numberOfVertices)
                          : Contour<vtkDiscreteFlyingEdges3D>(image, numberOfVertices);
  PeerMesh   result;
  result.time = stopwatch.Lap();
  result.numberOfOutputTriangles = static_cast<std::size_t>(contours->GetNumberOfCells());
  const auto triangles = ReadContours(contours, result.boundaries.points);
  result.boundaries.triangles = JoinSides(triangles, result.boundaries.points.size(), numberOfVertices);
  return result;
}
} // namespace tissue
