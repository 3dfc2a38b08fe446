/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/WallMeshPicture.h"

#include "Shared/Files/VTKFiles.h"
#include "Shared/Pictures/CellDrawing.h"
#include "Shared/Pictures/OffScreenWindow.h"
#include "Shared/Pictures/PictureLegend.h"
#include "Shared/Pictures/PictureObstacle.h"
#include "Shared/Pictures/PictureView.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
/** How far a cell is moved, as a part of its distance from the tissue's centre. */
constexpr double explosion = 0.35;
/** Pixels are rendered this many times finer, then averaged. */
constexpr int supersampling = 2;
constexpr int minimalSize = 64;
/** Twice as much is what OpenGL gives everywhere. */
constexpr int maximalSize = 4096;
/** As a part of the picture's size. */
constexpr double margin = 0.04;
/** In pixels. */
constexpr double outlineWidth = 1.3;
/** For each pixel; the time goes with it. */
constexpr int occlusionSamples = 16;
/** In degrees; sharper edges are not shaded smoothly. */
constexpr double creaseAngle = 40.0;
constexpr double ink[3] = { 0.14, 0.14, 0.18 };

/** Mean of the centres of the cells that are drawn. */
Point
FindCenter(const std::vector<Cell> & cells, const std::vector<VertexId> & shown)
{
  Point center{ { 0.0, 0.0, 0.0 } };
  for (const VertexId v : shown)
  {
    center = Combine(center, 1.0 / static_cast<double>(shown.size()), cells[v].center);
  }
  return center;
}

std::vector<VertexId>
FindCellsWithTriangles(const WallMesh & mesh, VertexId numberOfVertices)
{
  std::vector<bool> hasTriangle(numberOfVertices, false);
  for (const WallId wall : mesh.wallOfTriangle)
  {
    hasTriangle[mesh.walls[wall].cells[0]] = true;
    hasTriangle[mesh.walls[wall].cells[1]] = true;
  }
  std::vector<VertexId> cells;
  for (VertexId v = ExteriorVertex + 1; v < numberOfVertices; ++v)
  {
    if (hasTriangle[v])
    {
      cells.push_back(v);
    }
  }
  return cells;
}

/** Fills the drawings with the tissue cut open and with the tissue drawn apart; returns how to look at them. */
PictureView
DrawTissue(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Color> & colors, CellDrawing & cut,
           CellDrawing & apart)
{
  const VertexId              numberOfVertices = static_cast<VertexId>(cells.size());
  const std::vector<VertexId> shown = FindCellsWithTriangles(mesh, numberOfVertices);
  const Point                 center = FindCenter(cells, shown);
  const PictureView           view = ChooseView(mesh, cells, center);
  for (const VertexId v : shown)
  {
    const Vector fromCenter = Combine(cells[v].center, -1.0, center);
    const bool   isCutOut = vtkMath::Dot(fromCenter.data(), view.sides[0].data()) > 0.0 &&
                          vtkMath::Dot(fromCenter.data(), view.sides[1].data()) > 0.0;
    if (!isCutOut)
    {
      cut.Add(v, Vector{}, colors[v]);
    }
    apart.Add(v, Combine(Vector{}, explosion, fromCenter), colors[v]);
  }
  return view;
}

void
AddActors(vtkRenderer * renderer, const CellDrawing & drawing, const Vector & position)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(drawing.GetSurfaces());
  normals->SetFeatureAngle(creaseAngle);
  normals->ConsistencyOff();
  vtkNew<vtkPolyDataMapper> surfaceMapper;
  surfaceMapper->SetInputConnection(normals->GetOutputPort());
  // Surfaces give way to the outlines that lie on them.
  surfaceMapper->SetResolveCoincidentTopologyToPolygonOffset();
  surfaceMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1.0, 1.0);
  vtkNew<vtkActor> surfaces;
  surfaces->SetMapper(surfaceMapper);
  surfaces->SetPosition(position[0], position[1], position[2]);
  surfaces->GetProperty()->SetAmbient(0.4);
  surfaces->GetProperty()->SetDiffuse(0.68);
  surfaces->GetProperty()->SetInterpolationToPhong();
  renderer->AddActor(surfaces);

  vtkNew<vtkPolyDataMapper> outlineMapper;
  outlineMapper->SetInputData(drawing.GetOutlines());
  vtkNew<vtkActor> outlines;
  outlines->SetMapper(outlineMapper);
  outlines->SetPosition(position[0], position[1], position[2]);
  outlines->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
  outlines->GetProperty()->SetLineWidth(outlineWidth * supersampling);
  outlines->GetProperty()->LightingOff();
  renderer->AddActor(outlines);
}

/** The largest of 1, 2 and 5 times a power of ten that is not above the length. */
double
RoundDown(double length)
{
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double ratio = length / power;
  return power * (ratio >= 5.0 ? 5.0 : ratio >= 2.0 ? 2.0 : 1.0);
}

/** A bar in the lower left corner with its length above it; `pixelsPerUnit` as rendered. */
void
AddScaleBar(vtkRenderer * renderer, const std::array<int, 2> & size, double pixelsPerUnit, const std::string & unit)
{
  const double length = RoundDown(0.16 * size[0] / pixelsPerUnit);
  const double left = margin * size[1];
  const double right = left + length * pixelsPerUnit;
  const double bottom = margin * size[1];
  const double top = bottom + 0.008 * size[1];

  vtkNew<vtkPoints> points;
  points->InsertNextPoint(left, bottom, 0.0);
  points->InsertNextPoint(right, bottom, 0.0);
  points->InsertNextPoint(right, top, 0.0);
  points->InsertNextPoint(left, top, 0.0);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> bar;
  bar->SetPoints(points);
  bar->SetPolys(polygons);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(bar);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(ink[0], ink[1], ink[2]);
  renderer->AddActor2D(actor);

  std::ostringstream text;
  text << length << ' ' << unit;
  vtkNew<vtkTextActor> label;
  label->SetInput(text.str().c_str());
  label->GetTextProperty()->SetFontSize(static_cast<int>(0.028 * size[1]));
  label->GetTextProperty()->SetColor(ink[0], ink[1], ink[2]);
  label->GetTextProperty()->SetJustificationToCentered();
  label->SetPosition(0.5 * (left + right), top + 0.01 * size[1]);
  renderer->AddActor2D(label);
}

/** Darkens what lies between the cells, so that depth is seen. `length` is the height of the tissue. */
void
AddAmbientOcclusion(vtkRenderer * renderer, double length)
{
  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass>        occlusion;
  occlusion->SetDelegatePass(steps);
  occlusion->SetRadius(0.04 * length);
  occlusion->SetBias(0.004 * length);
  occlusion->SetKernelSize(occlusionSamples);
  occlusion->BlurOn();
  renderer->SetPass(occlusion);
}

/** A camera that looks at the origin; `height` is that of the picture, in the tissue's unit, of which `left` is left
 * free below. */
void
PlaceCamera(vtkRenderer * renderer, const PictureView & view, const PictureLayout & layout, double height, double left)
{
  const double   depth = layout.size[2];
  const Vector & up = view.axes[1];
  const Vector & toViewer = view.axes[2];
  vtkCamera *    camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(2.0 * depth * toViewer[0], 2.0 * depth * toViewer[1], 2.0 * depth * toViewer[2]);
  camera->SetViewUp(up[0], up[1], up[2]);
  camera->SetParallelScale(0.5 * height);
  camera->SetWindowCenter(0.0, -left / height);
  camera->SetClippingRange(depth, 3.0 * depth);
}

void
WritePicture(vtkRenderWindow * window, const std::string & path)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(grab->GetOutputPort());
  average->SetShrinkFactors(supersampling, supersampling, 1);
  average->AveragingOn();
  average->Update();
  WritePNG(average->GetOutput(), path);
}

void
RequireDrawable(const WallMesh & mesh, const std::vector<Cell> & cells, const WallMeshPictureOptions & options)
{
  const std::string obstacle = FindPictureObstacle();
  if (!obstacle.empty())
  {
    throw std::runtime_error(obstacle);
  }
  RequireConsistentIndices(mesh, static_cast<VertexId>(cells.size()));
  if (options.values && std::max(options.values->numbers.size(), options.values->texts.size()) != cells.size())
  {
    throw std::invalid_argument("The values are not those of the cells of the picture");
  }
  if (mesh.triangles.empty())
  {
    throw std::runtime_error("There is nothing to draw: the wall mesh has no triangle");
  }
  for (const int size : { options.width, options.height })
  {
    if (size < minimalSize || size > maximalSize)
    {
      throw std::runtime_error("A side of the picture is " + std::to_string(size) + " pixels, must be " +
                               std::to_string(minimalSize) + " to " + std::to_string(maximalSize));
    }
  }
}
} // namespace

void
WriteWallMeshPicture(const WallMesh & mesh, const std::vector<Cell> & cells, const std::string & path,
                     const WallMeshPictureOptions & options)
{
  RequireDrawable(mesh, cells, options);
  const auto                numberOfVertices = static_cast<VertexId>(cells.size());
  std::optional<ColorScale> scale;
  if (options.values)
  {
    scale.emplace(*options.values);
  }
  CellDrawing       cut(mesh, numberOfVertices);
  CellDrawing       apart(mesh, numberOfVertices);
  const PictureView view =
    DrawTissue(mesh, cells, scale ? scale->GetColors() : ChooseCellColors(mesh, numberOfVertices), cut, apart);
  const PictureLayout layout =
    PlaceSideBySide(view, FindBox(view, cut.GetSurfaces()), FindBox(view, apart.GetSurfaces()));

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddActors(renderer, cut, layout.leftPosition);
  AddActors(renderer, apart, layout.rightPosition);
  AddAmbientOcclusion(renderer, layout.size[1]);
  const std::array<int, 2> size{ { options.width * supersampling, options.height * supersampling } };
  const double             legend = scale ? LegendHeight : 0.0;
  const double             drawn = (1.0 - legend) * size[1];
  const double pixelsPerUnit = (1.0 - 2.0 * margin) * std::min(size[0] / layout.size[0], drawn / layout.size[1]);
  PlaceCamera(renderer, view, layout, size[1] / pixelsPerUnit, legend * size[1] / pixelsPerUnit);
  AddScaleBar(renderer, size, pixelsPerUnit, options.lengthUnit);
  if (scale)
  {
    AddLegend(renderer, *scale, options.values->title + scale->GetNote(), size);
  }

  const auto window = MakeOffScreenWindow();
  window->SetMultiSamples(0);
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
  window->Render();
  WritePicture(window, path);
}
} // namespace tissue
