/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/MembraneInput.h"

#include "Shared/CommandLine/OptionChecks.h"
#include "Shared/CommandLine/RunProgram.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkMembraneToTissueLabelImageFilter.h"

#include <nlohmann/json.hpp>

namespace tissue
{
void
AddMembraneOptions(CLI::App & app, const std::string & dark, MembraneOptions & options)
{
  const std::string group = "Membranes";
  app
    .add_option("--membraneSigma",
                options.sigma,
                "Smoothing of the image of membranes before the watershed, in the image's units; 0: none")
    ->check(InRange(0.0, 1e12))
    ->capture_default_str()
    ->group(group);
  app.add_flag(dark, options.isDark, "The membranes are darker than the cells, as in bright field")->group(group);
}

void
AddToJson(const MembraneOptions & options, nlohmann::ordered_json & json)
{
  if (!options.file.empty())
  {
    json["membrane"] = { { "file", options.file },
                         { "sigma", options.sigma },
                         { "markerSigma", options.markerSigma },
                         { "markerDepth", options.markerDepth },
                         { "noiseDepth", options.noiseDepth },
                         { "dark", options.isDark } };
  }
}

Stain
ReadStain(const std::string & path, const ImageOptions & options)
{
  Stopwatch             timer;
  const ScalarImageFile file = ReadScalarImage(path, options);
  Stain                 stain;
  stain.image = file.image;
  stain.description = DescribeImage(file.image.GetPointer(), file.pixelType);
  stain.description.unit = file.unit;
  stain.warnings = file.warnings;
  stain.readSeconds = timer.Lap().wallSeconds;
  return stain;
}

MembraneSegmentation
SegmentMembranes(const ScalarImage * membranes, const TissueLabelImage * cells, const MembraneOptions & options,
                 ProgressBar & progress)
{
  Stopwatch  timer;
  const auto segmentation = itk::MembraneToTissueLabelImageFilter<ScalarImage, TissueLabelImage>::New();
  segmentation->SetInput(membranes);
  if (cells != nullptr)
  {
    segmentation->SetCellImage(cells);
  }
  segmentation->SetSigma(options.sigma);
  segmentation->SetMarkerSigma(options.markerSigma);
  segmentation->SetMinimumDepth(options.markerDepth);
  segmentation->SetNoiseDepth(options.noiseDepth);
  segmentation->SetDarkMembranes(options.isDark);
  progress.Begin("Segmenting the membranes");
  progress.Observe(segmentation);
  segmentation->Update();
  const MembraneMinima minima{ segmentation->GetNoise(), segmentation->GetUsedDepth() };
  return { segmentation->GetOutput(), minima, timer.Lap().wallSeconds };
}

TissueInput
ReadMembranes(const MembraneOptions & options, const JunctionOptions & junctionOptions, ProgressBar & progress)
{
  return WithFileName(options.file, [&] {
    progress.Begin("Reading");
    const Stain                membranes = ReadStain(options.file, options.image);
    const MembraneSegmentation cells = SegmentMembranes(membranes.image, nullptr, options, progress);
    TissueInput                input;
    input.file = options.file;
    input.image = membranes.description;
    input.warnings = membranes.warnings;
    input.seconds.read = membranes.readSeconds;
    input.seconds.segment = cells.seconds;
    input.membraneMinima = cells.minima;
    input.extracted = ExtractTissueJunctions(cells.labels.GetPointer(), junctionOptions, progress);
    Append(CheckThatCellsTouch(input.GetJunctionSet(), std::nullopt), input.warnings);
    return input;
  });
}
} // namespace tissue
