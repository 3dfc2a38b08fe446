/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "MembraneInput.h"

#include "ImageFileCheck.h"
#include "ImageInput.h"
#include "JunctionInput.h"
#include "LapTimer.h"
#include "StandardErrorCapture.h"
#include "itkMembraneToTissueLabelImageFilter.h"

namespace tissue
{
MembraneImage::Pointer
ReadScalarImage(const std::string & path, const std::string & kind, TissueInput & input)
{
  LapTimer                        timer;
  StandardErrorCapture            messages;
  const itk::ImageIOBase::Pointer io = OpenImage(path);
  RequireVolume(io, kind);
  RequireAllVoxels(path, io);
  MembraneImage::Pointer image = ReadImage<MembraneImage>(path, std::nullopt);
  for (const std::string & warning : JudgeMessages(messages.Release(), io))
  {
    input.warnings.push_back(warning);
  }
  input.pixelType = itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType());
  DescribeImage(image.GetPointer(), input);
  input.readSeconds += timer.Lap();
  return image;
}

TissueLabelImage::Pointer
SegmentMembranes(const MembraneImage * membranes, const TissueLabelImage * cells, const MembraneOptions & options,
                 ProgressBar & progress, TissueInput & input)
{
  LapTimer   timer;
  const auto segmentation = itk::MembraneToTissueLabelImageFilter<MembraneImage, TissueLabelImage>::New();
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
  input.segmentSeconds += timer.Lap();
  return segmentation->GetOutput();
}

TissueInput
ReadMembranes(const TissueTessellationOptions & options, ProgressBar & progress)
{
  TissueInput input;
  progress.Begin("Reading");
  const MembraneImage::Pointer    membranes = ReadScalarImage(options.membrane.file, "an image of membranes", input);
  const TissueLabelImage::Pointer cells = SegmentMembranes(membranes, nullptr, options.membrane, progress, input);
  ExtractTissueJunctions(cells.GetPointer(), options, progress, input);
  CheckThatCellsTouch(input.junctions->GetJunctionSet(), options, input);
  return input;
}
} // namespace tissue
