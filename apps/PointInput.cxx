/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "PointInput.h"

#include "ImageInput.h"
#include "JunctionInput.h"
#include "MembraneInput.h"
#include "PointFile.h"
#include "RunProgram.h"
#include "TissueTessellationCore/PointJunctions.h"
#include "itkPointSetToTissueLabelImageFilter.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace tissue
{
namespace
{
using PointSetType = itk::PointSet<double, 3>;

/** Centres of cells by ascending labels. */
struct LabelledPoints
{
  std::vector<Point> points;
  std::vector<Label> labels;
};

/** In the order of their labels; those of a file without are numbered from 1 on. Points at the place of an earlier one
 * are left out, with a warning. */
LabelledPoints
ReadPoints(const std::string & path, TissueInput & input)
{
  PointFile file = ReadPointFile(path);
  if (file.labels.empty())
  {
    file.labels.resize(file.points.size());
    std::iota(file.labels.begin(), file.labels.end(), 1);
  }
  std::map<Label, std::size_t> pointOfLabel;
  std::map<Point, std::size_t> pointAt;
  std::vector<std::string>     repeated;
  for (std::size_t i = 0; i < file.points.size(); ++i)
  {
    const auto ofLabel = pointOfLabel.emplace(file.labels[i], i);
    if (!ofLabel.second)
    {
      throw std::runtime_error(file.places[i] + " has the label " + std::to_string(file.labels[i]) + " of " +
                               file.places[ofLabel.first->second]);
    }
    const auto at = pointAt.emplace(file.points[i], i);
    if (!at.second)
    {
      repeated.push_back(file.places[i] + " that of " + file.places[at.first->second]);
      pointOfLabel.erase(file.labels[i]);
    }
  }
  if (!repeated.empty())
  {
    input.warnings.push_back(std::to_string(repeated.size()) + " of " + std::to_string(file.points.size()) +
                             " points repeat another and are left out (" + repeated.front() +
                             (repeated.size() > 1 ? ", ...)" : ")"));
  }
  LabelledPoints result;
  for (const auto & [label, i] : pointOfLabel)
  {
    result.points.push_back(file.points[i]);
    result.labels.push_back(label);
  }
  return result;
}

/** The centres of the cells of a label image. */
LabelledPoints
ReadCenters(const std::string & path, ProgressBar & progress, TissueInput & input)
{
  TissueTessellationOptions options;
  options.labels = path;
  options.parameters.separateVoids = false;
  options.parameters.fitToImage = false;
  const TissueInput image = ReadTissue(options, progress);
  input.warnings = image.warnings;
  input.readSeconds = image.readSeconds;
  LabelledPoints            result;
  const std::vector<Cell> & cells = image.junctions->GetJunctionSet().cells;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    result.points.push_back(cells[v].center);
    result.labels.push_back(cells[v].label);
  }
  return result;
}

/** An image without pixels that fills the box of a file's. */
itk::ImageBase<3>::Pointer
ReadBox(const std::string & path)
{
  const itk::ImageIOBase::Pointer io = OpenImage(path);
  RequireVolume(io, "an image of a tissue");
  const auto reader = itk::ImageFileReader<MembraneImage>::New();
  reader->SetFileName(path);
  reader->UpdateOutputInformation();
  const auto box = itk::ImageBase<3>::New();
  box->CopyInformation(reader->GetOutput());
  return box;
}

TissueLabelImage::Pointer
MakeLabelImage(const std::vector<Point> & points, const itk::ImageBase<3> * box,
               const NucleiTessellationOptions & options, ProgressBar & progress, TissueInput & input)
{
  LapTimer   timer;
  const auto set = PointSetType::New();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    set->SetPoint(static_cast<PointSetType::PointIdentifier>(i), PointSetType::PointType(points[i].data()));
  }
  const auto filter = itk::PointSetToTissueLabelImageFilter<PointSetType, TissueLabelImage>::New();
  filter->SetInput(set);
  if (box != nullptr)
  {
    filter->SetReferenceImage(box);
  }
  filter->SetVoxelsPerCell(options.voxelsPerCell);
  progress.Begin("Fitting cells to the points");
  progress.Observe(filter);
  filter->Update();
  input.segmentSeconds += timer.Lap();
  return filter->GetOutput();
}

/** Gives the cells, numbered from 1 on in the order of the points, the labels of these. */
void
NameCells(const std::vector<Label> & labels, TissueInput & input)
{
  JunctionSet junctions = input.junctions->GetJunctionSet();
  for (std::size_t v = 1; v < junctions.cells.size(); ++v)
  {
    junctions.cells[v].label = labels[static_cast<std::size_t>(junctions.cells[v].label - 1)];
  }
  input.junctions->SetJunctionSet(std::move(junctions));
}
} // namespace

TissueInput
ReadPointTissue(const NucleiTessellationOptions & options, ProgressBar & progress)
{
  TissueInput input;
  progress.Begin("Reading");
  const LabelledPoints points =
    options.centersOf.empty() ? ReadPoints(options.labels, input) : ReadCenters(options.centersOf, progress, input);
  input.numberOfPoints = points.points.size();
  JunctionSet cells = MakePointJunctions(points.points, points.labels);
  const bool  hasMembranes = !options.membrane.file.empty();
  if (options.preset == "paper" && !hasMembranes)
  {
    input.junctions = itk::TissueJunctions::New();
    input.junctions->SetJunctionSet(std::move(cells));
    return input;
  }
  itk::ImageBase<3>::Pointer box;
  MembraneImage::Pointer     membranes;
  const std::string          boxFile = options.box.empty() ? options.centersOf : options.box;
  if (hasMembranes)
  {
    membranes = WithFileName(options.membrane.file,
                             [&] { return ReadScalarImage(options.membrane.file, "an image of membranes", input); });
    box = membranes.GetPointer();
  }
  else if (!boxFile.empty())
  {
    box = WithFileName(boxFile, [&] { return ReadBox(boxFile); });
  }
  TissueLabelImage::Pointer labels = MakeLabelImage(points.points, box, options, progress, input);
  if (hasMembranes)
  {
    labels = WithFileName(options.membrane.file,
                          [&] { return SegmentMembranes(membranes, labels, options.membrane, progress, input); });
  }
  DescribeImage(labels.GetPointer(), input);
  ExtractTissueJunctions(labels.GetPointer(), options, progress, input);
  NameCells(points.labels, input);
  return input;
}
} // namespace tissue
