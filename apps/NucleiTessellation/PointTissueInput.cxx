/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/PointTissueInput.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Images/ImageInput.h"
#include "Shared/Points/PointFileReader.h"
#include "Shared/Reconstruction/JunctionInput.h"
#include "Shared/Reconstruction/MembraneInput.h"
#include "TissueTessellationCore/Points/PointJunctions.h"
#include "itkPointSetToTissueLabelImageFilter.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace tissue
{
namespace
{
// Its default coordinates are floats.
using PointSetType = itk::PointSet<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double>>;

/** Centres of cells by ascending labels. */
struct LabelledPoints
{
  std::vector<Point> points;
  std::vector<Label> labels;
  Label              exteriorLabel = 0;
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
  ReconstructionOptions options;
  options.labels = path;
  options.parameters.separateVoids = false;
  options.parameters.fitToImage = false;
  const TissueInput image = ReadTissue(options, progress);
  input.warnings = image.warnings;
  input.readSeconds = image.readSeconds;
  LabelledPoints result;
  result.exteriorLabel = image.exteriorLabel;
  const std::vector<Cell> & cells = image.junctions->GetJunctionSet().cells;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    result.points.push_back(cells[v].center);
    result.labels.push_back(cells[v].label);
  }
  return result;
}

/** The nuclei of an image, numbered from 1 on. */
LabelledPoints
FindNuclei(const NucleiTessellationOptions & options, ProgressBar & progress, TissueInput & input)
{
  constexpr std::size_t      minimum = 4;
  const ScalarImage::Pointer image = ReadStain(options.labels, input);
  Stopwatch                  timer;
  const auto                 detection = DetectNuclei(image, options.detection, progress);
  const auto * const         nuclei = detection->GetOutput();
  LabelledPoints             result;
  for (itk::SizeValueType i = 0; i < nuclei->GetNumberOfPoints(); ++i)
  {
    const auto point = nuclei->GetPoint(i);
    result.points.push_back({ { point[0], point[1], point[2] } });
    result.labels.push_back(static_cast<Label>(i + 1));
  }
  if (result.points.size() < minimum)
  {
    throw std::runtime_error(std::to_string(result.points.size()) + " nuclei" + DescribeSearch(*detection, "have") +
                             ", at least " + std::to_string(minimum) + " are needed");
  }
  input.segmentSeconds += timer.Lap().wallSeconds;
  return result;
}

LabelledPoints
ReadCells(const NucleiTessellationOptions & options, ProgressBar & progress, TissueInput & input)
{
  if (!options.centersOf.empty())
  {
    return ReadCenters(options.centersOf, progress, input);
  }
  return IsPointFile(options.labels) ? ReadPoints(options.labels, input) : FindNuclei(options, progress, input);
}

/** An image without pixels that fills the box of a file's. */
itk::ImageBase<3>::Pointer
ReadBox(const std::string & path)
{
  const itk::ImageIOBase::Pointer io = OpenImage(path);
  RequireVolume(io, "an image of a tissue");
  const auto reader = itk::ImageFileReader<ScalarImage>::New();
  reader->SetFileName(path);
  reader->UpdateOutputInformation();
  const auto box = itk::ImageBase<3>::New();
  box->CopyInformation(reader->GetOutput());
  return box;
}

/** The image that fills the box that the points were seen in; empty if there is none. */
std::string
FindBoxFile(const NucleiTessellationOptions & options)
{
  const bool hasImage = !options.centersOf.empty() || !IsPointFile(options.labels);
  return options.box.empty() && hasImage ? options.labels : options.box;
}

/** The label image of a tissue, and how sure it is which of its cells meet. */
struct EstimatedTissue
{
  TissueLabelImage::Pointer labels;
  std::vector<JunctionVote> votes;
};

EstimatedTissue
MakeLabelImage(const std::vector<Point> & points, const itk::ImageBase<3> * box,
               const NucleiTessellationOptions & options, ProgressBar & progress, TissueInput & input)
{
  Stopwatch  timer;
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
  input.segmentSeconds += timer.Lap().wallSeconds;
  return { filter->GetOutput(), filter->GetVotes() };
}

/** Gives the cells, numbered from 1 on in the order of the points, the labels of these; and the votes on them. */
void
CompleteJunctions(const LabelledPoints & points, std::vector<JunctionVote> votes, TissueInput & input)
{
  JunctionSet junctions = input.junctions->GetJunctionSet();
  for (std::size_t v = 1; v < junctions.cells.size(); ++v)
  {
    junctions.cells[v].label = points.labels[static_cast<std::size_t>(junctions.cells[v].label - 1)];
  }
  junctions.cells[ExteriorVertex].label = points.exteriorLabel;
  junctions.votes = std::move(votes);
  input.junctions->SetJunctionSet(std::move(junctions));
}

/** Warns of options that the paper's method, from points alone, has no use for. */
void
WarnOfUnused(const NucleiTessellationOptions & options, TissueInput & input)
{
  if (!options.box.empty())
  {
    input.warnings.push_back("--box is not used: --preset paper makes walls of the points alone");
  }
  if (!options.junctions.empty())
  {
    input.warnings.push_back("--junctions: points alone have none in an image, the table is empty");
  }
}
} // namespace

TissueInput
ReadPointTissue(const NucleiTessellationOptions & options, ProgressBar & progress)
{
  TissueInput input;
  progress.Begin("Reading");
  const LabelledPoints points = ReadCells(options, progress, input);
  input.exteriorLabel = points.exteriorLabel;
  input.numberOfPoints = points.points.size();
  JunctionSet cells = MakePointJunctions(points.points, points.labels, points.exteriorLabel);
  const bool  hasMembranes = !options.membrane.file.empty();
  if (options.preset == "paper" && !hasMembranes)
  {
    WarnOfUnused(options, input);
    input.junctions = itk::TissueJunctions::New();
    input.junctions->SetJunctionSet(std::move(cells));
    return input;
  }
  itk::ImageBase<3>::Pointer box;
  ScalarImage::Pointer       membranes;
  const std::string          boxFile = FindBoxFile(options);
  if (hasMembranes)
  {
    membranes = ReadStain(options.membrane.file, input);
    box = membranes.GetPointer();
  }
  else if (!boxFile.empty())
  {
    box = WithFileName(boxFile, [&] { return ReadBox(boxFile); });
  }
  EstimatedTissue tissue = MakeLabelImage(points.points, box, options, progress, input);
  if (hasMembranes)
  {
    // What the membranes show is known better than by votes.
    tissue = { WithFileName(
                 options.membrane.file,
                 [&] { return SegmentMembranes(membranes, tissue.labels, options.membrane, progress, input); }),
               {} };
  }
  DescribeImage(tissue.labels.GetPointer(), input);
  ExtractTissueJunctions(tissue.labels.GetPointer(), options, progress, input);
  input.exteriorLabel = points.exteriorLabel;
  CompleteJunctions(points, std::move(tissue.votes), input);
  return input;
}
} // namespace tissue
