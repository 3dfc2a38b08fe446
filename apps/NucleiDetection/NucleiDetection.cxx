/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// Finds nuclei in an image of their stain: NucleiDetection [options] image points.csv

#include "NucleiDetection/BlobPicture.h"
#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/CommandLine/RunOptions.h"
#include "Shared/CommandLine/RunProgram.h"
#include "Shared/CommandLine/SlicerOptions.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/ReturnParameters.h"
#include "Shared/Images/ScalarImageInput.h"
#include "Shared/Points/NucleiSearch.h"
#include "Shared/Points/PointFileWriter.h"

#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace tissue;

struct Options
{
  std::string      image;
  std::string      points;
  std::string      picture;
  std::string      returnParameters;
  DetectionOptions detection;
  ImageOptions     input;
  RunOptions       run;
};

void
AddOptions(CLI::App & app, Options & options)
{
  app.option_defaults()->always_capture_default();
  app.set_version_flag("--version", TISSUE_TESSELLATION_VERSION);
  app
    .add_option(
      "image", options.image, "3-D image of one component, in any of ITK's formats, TIFF, HDF5 (FILE:/NAME) or .inr.gz")
    ->required();
  app.add_option("points", options.points, "Points to write: .csv, .mrk.json or .fcsv (3D Slicer), or .vtp (ParaView)")
    ->required();
  app
    .add_option(
      "--picture", options.picture, "Also write a PNG: the brightest voxels along the last axis, the blobs as circles")
    ->check(EndsIn(".png"));
  AddDetectionOptions(app, options.detection);
  AddImageOptions(app, options.input);
  AddRunOptions(app, options.run);
  const SlicerModule module{
    "Nuclei Detection",
    { { "image", SlicerUse::Image }, { "points", SlicerUse::OutputPoints } },
    { { "numberOfNuclei", "integer", "Nuclei that were found" },
      { "smallestScale", "double", "Standard deviation of the smallest that were looked for" },
      { "largestScale", "double", "Standard deviation of the largest that were looked for" } }
  };
  AddSlicerOptions(app, module, options.returnParameters);
}

/** Throws for everything that would make the outputs impossible, before the work. */
void
RequireOutputs(const Options & options)
{
  RequirePointFormat(options.points);
  for (const std::string & path : { options.points, options.picture, options.returnParameters })
  {
    if (!path.empty())
    {
      OutputFiles::RequireWritable(path);
      OutputFiles::RequireNotInput(path, options.image);
    }
  }
}

/** The nuclei, numbered from 1 on. */
PointTable
ToTable(const DetectionFilter & detection)
{
  const auto * const blobs = detection.GetOutput();
  PointTable         table;
  table.columns = { { "Label", {} }, { "scale", {} }, { "radius", {} }, { "response", {} } };
  for (itk::SizeValueType i = 0; i < blobs->GetNumberOfPoints(); ++i)
  {
    const auto point = blobs->GetPoint(i);
    const auto data = blobs->GetPointData()->GetElement(i);
    table.points.push_back({ { point[0], point[1], point[2] } });
    const double values[] = { static_cast<double>(i + 1), data[0], BlobRadius(data[0]), data[1] };
    for (std::size_t c = 0; c < table.columns.size(); ++c)
    {
      table.columns[c].second.push_back(values[c]);
    }
  }
  return table;
}

/** Those that 3D Slicer was told of. */
ReturnParameters
ResultsOf(const DetectionFilter & detection)
{
  return { { "numberOfNuclei", static_cast<double>(detection.GetOutput()->GetNumberOfPoints()) },
           { "smallestScale", detection.GetUsedMinimumScale() },
           { "largestScale", detection.GetUsedMaximumScale() } };
}

void
WriteOutputs(const DetectionFilter & detection, const ScalarImage * image, const Options & options,
             ProgressBar & progress)
{
  const PointTable table = ToTable(detection);
  progress.Begin("Writing");
  OutputFiles files;
  files.Add(options.points,
            [&](const std::string & path) { WritePoints(table, path, RequirePointFormat(options.points)); });
  if (!options.picture.empty())
  {
    files.Add(options.picture, [&](const std::string & path) { WriteBlobPicture(image, table, path); });
  }
  if (!options.returnParameters.empty())
  {
    files.Add(options.returnParameters,
              [&](const std::string & path) { WriteReturnParameters(ResultsOf(detection), path); });
  }
  files.Commit();
  progress.End();
}

void
Say(const Options & options, std::vector<std::string> warnings, const DetectionFilter & detection)
{
  const auto number = detection.GetOutput()->GetNumberOfPoints();
  for (const std::string & warning : WarningsOf(detection))
  {
    warnings.push_back(options.image + ": " + warning);
  }
  if (number == 0)
  {
    warnings.push_back(options.image + ": no nuclei" + DescribeSearch(detection, "with"));
  }
  for (const std::string & warning : warnings)
  {
    std::cerr << "NucleiDetection: warning: " << warning << '\n';
  }
  if (!options.run.isQuiet)
  {
    std::cout << options.points << ": " << number << " nuclei of scales from " << detection.GetUsedMinimumScale()
              << " to " << detection.GetUsedMaximumScale() << ", responses of " << detection.GetUsedThreshold()
              << " and more; the noise has a deviation of " << detection.GetNoise() << '\n';
  }
}
} // namespace

int
main(int argc, char * argv[])
{
  return RunProgram("NucleiDetection", [&] {
    Options  options;
    CLI::App app("Finds nuclei, or other blobs, in a 3-D image, by the maxima of its scale space.", "NucleiDetection");
    AddOptions(app, options);
    if (!Parse(app, argc, argv))
    {
      return;
    }
    RequireOutputs(options);
    UseThreads(options.run.threads);
    ProgressBar progress(options.run.GetProgressStyle());

    progress.Begin("Reading");
    const ScalarImageFile file = ReadScalarImage(options.image, options.input);
    const auto            detection =
      WithFileName(options.image, [&] { return DetectNuclei(file.image, options.detection, progress); });
    WriteOutputs(*detection, file.image, options, progress);
    Say(options, file.warnings, *detection);
  });
}
