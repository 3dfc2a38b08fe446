/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiTessellation/PointTissueInput.h"

#include "NucleiTessellation/PointBox.h"
#include "NucleiTessellation/PointUnits.h"
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Images/ImageInput.h"
#include "Shared/Points/PointFileReader.h"
#include "Shared/Reconstruction/JunctionInput.h"
#include "Shared/Reconstruction/LabelImageInput.h"
#include "Shared/Reconstruction/MembraneInput.h"
#include "TissueTessellationCore/Points/PointJunctions.h"
#include "TissueTessellationCore/Points/PointTissue.h"
#include "itkPointSetToTissueLabelImageFilter.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
// Its default coordinates are floats.
using PointSetType = itk::PointSet<double, 3, itk::DefaultStaticMeshTraits<double, 3, 3, double>>;

/** Centres of cells by ascending labels, and what is to be said of where they are from. */
struct LabelledPoints
{
  std::vector<Point> points;
  std::vector<Label> labels;
  Label              exteriorLabel = 0;
  /** Of each point where it is in its file; empty where it is from an image. */
  std::vector<std::string> places;
  /** Of the labels, and of the coordinates, where the file has them. */
  std::map<Label, std::string> names;
  std::string                  unit;
  ImageDescription             image;
  std::vector<std::string>     warnings;
  InputSeconds                 seconds;
};

/** In the order of their labels; those of a file without are numbered from 1 on. Points at the place of an earlier one
 * are left out, with a warning; where a cell has the label 0 the exterior's is -1. */
LabelledPoints
ReadPoints(const std::string & path, const PointFileOptions & options)
{
  PointFile file = ReadPointFile(path, options);
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
  LabelledPoints result;
  result.warnings = file.warnings;
  result.unit = file.unit;
  if (!repeated.empty())
  {
    result.warnings.push_back(std::to_string(repeated.size()) + " of " + std::to_string(file.points.size()) +
                              " points repeat another and are left out (" + repeated.front() +
                              (repeated.size() > 1 ? ", ...)" : ")"));
  }
  for (const auto & [label, i] : pointOfLabel)
  {
    result.points.push_back(file.points[i]);
    result.labels.push_back(label);
    result.places.push_back(file.places[i]);
    if (!file.names.empty())
    {
      result.names.emplace(label, file.names[i]);
    }
  }
  if (pointOfLabel.count(result.exteriorLabel) > 0)
  {
    result.exteriorLabel = -1;
    result.warnings.push_back("the label 0 is that of a cell: the exterior has the label -1");
  }
  return result;
}

/** The centres of the cells of a label image. */
LabelledPoints
ReadCenters(const CenterOptions & centers, ProgressBar & progress)
{
  LabelImageOptions options;
  options.file = centers.centersOf;
  options.input = centers.image;
  const TissueInput image = ExtractCells(ReadLabelImage(options, progress), progress);
  LabelledPoints    result;
  result.exteriorLabel = image.extracted.exteriorLabel;
  result.image.unit = image.image.unit;
  result.warnings = image.warnings;
  result.seconds.read = image.seconds.read;
  const std::vector<Cell> & cells = image.GetJunctionSet().cells;
  for (std::size_t v = 1; v < cells.size(); ++v)
  {
    result.points.push_back(cells[v].center);
    result.labels.push_back(cells[v].label);
  }
  return result;
}

/** The nuclei of an image, numbered from 1 on. */
LabelledPoints
FindNuclei(const CenterOptions & options, ProgressBar & progress)
{
  constexpr std::size_t minimum = 4;
  const Stain           stain = ReadStain(options.file, options.image);
  Stopwatch             timer;
  const auto            detection = DetectNuclei(stain.image, options.detection, progress);
  const auto * const    nuclei = detection->GetOutput();
  LabelledPoints        result;
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
  result.image = stain.description;
  result.warnings = stain.warnings;
  for (const std::string & warning : WarningsOf(*detection))
  {
    result.warnings.push_back(options.file + ": " + warning);
  }
  result.seconds.read = stain.readSeconds;
  result.seconds.segment = timer.Lap().wallSeconds;
  return result;
}

/** \throws std::runtime_error where the file is there, but no image that ITK reads. */
void
RequireImageOrPoints(const std::string & path)
{
  if (std::filesystem::is_regular_file(path) && !IsImageFile(path))
  {
    throw std::runtime_error(
      "neither an image in a format that ITK reads nor a file of points: tables are .csv, .tsv or "
      ".txt, as a spreadsheet saves them, others .fcsv, .mrk.json, .ply and .vtp");
  }
}

LabelledPoints
ReadCells(const CenterOptions & options, ProgressBar & progress)
{
  progress.Begin("Reading");
  if (!options.centersOf.empty())
  {
    return ReadCenters(options, progress);
  }
  if (IsPointFile(options.file))
  {
    return ReadPoints(options.file, options.points);
  }
  if (options.points.IsOfTables() || options.points.spacing)
  {
    throw std::runtime_error("--columns, --firstLine and --pointSpacing are for files of points");
  }
  RequireImageOrPoints(options.file);
  return FindNuclei(options, progress);
}

/** What to call a point: its place in its file, or its label, and where it is. */
std::string
NamePoint(const LabelledPoints & points, std::size_t i)
{
  std::ostringstream text;
  const Point &      p = points.points[i];
  text << (points.places.empty() ? "point " + std::to_string(points.labels[i]) : points.places[i]) << " at (" << p[0]
       << ", " << p[1] << ", " << p[2] << ')';
  return text.str();
}

/** Leaves out the points that are far from all others, or warns of them; both name them. */
void
JudgeOutliers(bool dropsThem, LabelledPoints & points)
{
  constexpr std::size_t          mostNamed = 5;
  const std::vector<std::size_t> outliers = FindOutliers(points.points);
  if (outliers.empty())
  {
    return;
  }
  std::string text = std::to_string(outliers.size()) + (outliers.size() == 1 ? " point is" : " points are") +
                     " far from all others" + (dropsThem ? " and left out: " : ": ");
  for (std::size_t i = 0; i < std::min(mostNamed, outliers.size()); ++i)
  {
    text += (i > 0 ? ", " : "") + NamePoint(points, outliers[i]);
  }
  points.warnings.push_back(text + (outliers.size() > mostNamed ? ", ..." : "") +
                            (dropsThem ? "" : "; --dropOutliers leaves such out"));
  const auto dropFrom = [&outliers](auto & list) {
    for (auto i = outliers.rbegin(); !list.empty() && i != outliers.rend(); ++i)
    {
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(*i));
    }
  };
  if (dropsThem)
  {
    for (const std::size_t i : outliers)
    {
      points.names.erase(points.labels[i]);
    }
    dropFrom(points.points);
    dropFrom(points.labels);
    dropFrom(points.places);
  }
}

/** Says of a refusal which points are far from all others, where that may be its cause. */
template <typename TWork>
auto
WithOutliers(const LabelledPoints & points, const TWork & work) -> decltype(work())
{
  try
  {
    return work();
  }
  catch (const itk::ExceptionObject & error)
  {
    const std::vector<std::size_t> outliers = FindOutliers(points.points);
    if (outliers.empty())
    {
      throw;
    }
    throw std::runtime_error(ToMessage(error) + "; far from all others is " + NamePoint(points, outliers.front()) +
                             (outliers.size() > 1 ? " and " + std::to_string(outliers.size() - 1) + " more" : "") +
                             ": --dropOutliers leaves such points out");
  }
}

/** The label image of a tissue, and how sure it is which of its cells meet. */
struct EstimatedTissue
{
  TissueLabelImage::Pointer      labels;
  itk::TissueVotes::ConstPointer votes;
  double                         seconds = 0.0;
};

/** \param box null: none is known. */
EstimatedTissue
EstimateTissue(const std::vector<Point> & points, const itk::ImageBase<3> * box, const CenterOptions & options,
               ProgressBar & progress)
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
  using Layer = itk::PointTissueEnums::Layer;
  filter->SetVoxelsPerCell(options.voxelsPerCell);
  filter->SetLayer(options.layer == "on" ? Layer::On : options.layer == "off" ? Layer::Off : Layer::Automatic);
  progress.Begin("Fitting cells to the points");
  progress.Observe(filter);
  filter->Update();
  return { filter->GetOutput(), filter->GetVotes(), timer.Lap().wallSeconds };
}

/** The tissue that the membranes show around its estimate. What they show is known better than by votes. */
EstimatedTissue
FollowMembranes(const EstimatedTissue & estimate, const ScalarImage * membranes, const MembraneOptions & options,
                ProgressBar & progress)
{
  const auto segmentation =
    WithFileName(options.file, [&] { return SegmentMembranes(membranes, estimate.labels, options, progress); });
  return { segmentation.labels, nullptr, estimate.seconds + segmentation.seconds };
}

/** The junctions of a tissue whose cells are numbered from 1 on in the order of the points, whose labels they get. */
ExtractedJunctions
ExtractPointJunctions(const EstimatedTissue & tissue, const LabelledPoints & points, bool makesVolume,
                      ProgressBar & progress)
{
  JunctionOptions options;
  options.makesVolume = makesVolume;
  options.votes = tissue.votes;
  ExtractedJunctions extracted = ExtractTissueJunctions(tissue.labels.GetPointer(), options, progress);
  extracted.exteriorLabel = points.exteriorLabel;
  JunctionSet junctions = extracted.junctions->GetJunctionSet();
  for (std::size_t v = 1; v < junctions.cells.size(); ++v)
  {
    junctions.cells[v].label = points.labels[static_cast<std::size_t>(junctions.cells[v].label - 1)];
  }
  junctions.cells[ExteriorVertex].label = points.exteriorLabel;
  extracted.junctions->SetJunctionSet(std::move(junctions));
  return extracted;
}

/** The tissue of an image made of the points, which has junctions.
 * \param input what is known of the points so far. */
TissueInput
MakeTissue(const LabelledPoints & points, const NucleiTessellationOptions & options, TissueInput input,
           ProgressBar & progress)
{
  const bool  hasMembranes = !options.membrane.file.empty();
  const Stain membranes = hasMembranes ? ReadStain(options.membrane.file, options.membrane.image) : Stain();
  itk::ImageBase<3>::Pointer box = membranes.image.GetPointer();
  if (!hasMembranes)
  {
    box = FindBox(options.centers, input);
  }
  const std::string unit = hasMembranes ? membranes.description.unit : input.image.unit;
  if (box)
  {
    RequireUnitOfBox(points.points, points.unit, box, unit);
  }
  EstimatedTissue tissue = EstimateTissue(points.points, box, options.centers, progress);
  if (hasMembranes)
  {
    tissue = FollowMembranes(tissue, membranes.image, options.membrane, progress);
  }
  const std::string & pixelType = hasMembranes ? membranes.description.pixelType : input.image.pixelType;
  input.image = DescribeImage(tissue.labels.GetPointer(), pixelType);
  input.image.unit = unit;
  const bool makesVolume = options.method.parameters.fitToImage || !options.projection.signals.empty();
  input.extracted = ExtractPointJunctions(tissue, points, makesVolume, progress);
  input.seconds.read += membranes.readSeconds;
  input.seconds.segment += tissue.seconds;
  Append(membranes.warnings, input.warnings);
  return input;
}

/** Warnings of options that the paper's method, from points alone, has no use for. */
std::vector<std::string>
FindUnused(const NucleiTessellationOptions & options)
{
  std::vector<std::string> warnings;
  if (!options.centers.box.empty())
  {
    warnings.push_back("--box is not used: --preset paper makes walls of the points alone");
  }
  if (!options.outputs.junctions.empty())
  {
    warnings.push_back("--junctions: points alone have none in an image, the table is empty");
  }
  return warnings;
}
} // namespace

TissueInput
ReadPointTissue(const NucleiTessellationOptions & options, ProgressBar & progress)
{
  return WithFileName(options.centers.Source(), [&] {
    LabelledPoints points = ReadCells(options.centers, progress);
    JudgeOutliers(options.centers.dropsOutliers, points);
    if (options.evaluation.byLabel && !points.names.empty())
    {
      throw std::runtime_error("--evaluateByLabel needs labels that are numbers: here they are names");
    }
    JunctionSet cells = MakePointJunctions(points.points, points.labels, points.exteriorLabel);
    TissueInput input;
    input.file = options.centers.Source();
    input.numberOfPoints = points.points.size();
    input.pointUnit = points.unit;
    input.names = points.names;
    input.image = points.image;
    input.warnings = points.warnings;
    input.seconds = points.seconds;
    if (options.method.preset != "paper" || !options.membrane.file.empty())
    {
      return WithOutliers(points, [&] { return MakeTissue(points, options, std::move(input), progress); });
    }
    Append(FindUnused(options), input.warnings);
    input.extracted.exteriorLabel = points.exteriorLabel;
    input.extracted.junctions = itk::TissueJunctions::New();
    input.extracted.junctions->SetJunctionSet(std::move(cells));
    return input;
  });
}
} // namespace tissue
