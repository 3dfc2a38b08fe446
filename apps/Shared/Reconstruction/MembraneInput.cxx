/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/MembraneInput.h"

#include "Shared/Reconstruction/JunctionInput.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkMembraneToTissueLabelImageFilter.h"

namespace tissue
{
ScalarImage::Pointer
ReadStain(const std::string & path, TissueInput & input)
{
  Stopwatch             timer;
  const ScalarImageFile file = ReadScalarImage(path);
  input.warnings.insert(input.warnings.end(), file.warnings.begin(), file.warnings.end());
  input.pixelType = file.pixelType;
  DescribeImage(file.image.GetPointer(), input);
  input.readSeconds += timer.Lap().wallSeconds;
  return file.image;
}

TissueLabelImage::Pointer
SegmentMembranes(const ScalarImage * membranes, const TissueLabelImage * cells, const MembraneOptions & options,
                 ProgressBar & progress, TissueInput & input)
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
  progress.Begin("Segmenting the membranes");
  progress.Observe(segmentation);
  segmentation->Update();
  input.segmentSeconds += timer.Lap().wallSeconds;
  return segmentation->GetOutput();
}

TissueInput
ReadMembranes(const ReconstructionOptions & options, ProgressBar & progress)
{
  TissueInput input;
  progress.Begin("Reading");
  const ScalarImage::Pointer      membranes = ReadStain(options.membrane.file, input);
  const TissueLabelImage::Pointer cells = SegmentMembranes(membranes, nullptr, options.membrane, progress, input);
  ExtractTissueJunctions(cells.GetPointer(), options, progress, input);
  CheckThatCellsTouch(input.junctions->GetJunctionSet(), options, input);
  return input;
}
} // namespace tissue
