/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef JunctionInput_h
#define JunctionInput_h

#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <algorithm>

namespace tissue
{
template <typename TImage>
void
DescribeImage(const TImage * image, TissueInput & input)
{
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    input.size[axis] = image->GetLargestPossibleRegion().GetSize(axis);
    input.spacing[axis] = image->GetSpacing()[axis];
  }
}

/** Extracts the junctions of a label image for the input, and what the walls are fitted to if they are. */
template <typename TImage>
void
ExtractJunctions(const TImage * image, const ReconstructionOptions & options, ProgressBar & progress,
                 TissueInput & input)
{
  Stopwatch  timer;
  const auto extraction = itk::LabelJunctionExtractionFilter<TImage>::New();
  extraction->SetInput(image);
  if (options.exteriorLabel)
  {
    extraction->SetExteriorLabel(*options.exteriorLabel);
  }
  extraction->SetZeroIsCell(options.zeroIsCell);
  extraction->SetSeparateVoids(options.parameters.separateVoids);
  extraction->SetGenerateLabelVolume(options.parameters.fitToImage);
  progress.Begin("Finding junctions");
  progress.Observe(extraction);
  extraction->Update();
  input.exteriorLabel = extraction->GetUsedExteriorLabel();
  input.junctions = extraction->GetOutput();
  input.junctions->DisconnectPipeline();
  if (options.parameters.fitToImage)
  {
    input.volume = extraction->GetLabelVolume();
    input.volume->DisconnectPipeline();
  }
  input.extractSeconds = timer.Lap().wallSeconds;
}

/** Likewise of a label image that we have made, whose exterior is 0 where it has one. */
template <typename TImage>
void
ExtractTissueJunctions(const TImage * image, ReconstructionOptions options, ProgressBar & progress, TissueInput & input)
{
  const auto * const begin = image->GetBufferPointer();
  const auto * const end = begin + image->GetBufferedRegion().GetNumberOfPixels();
  if (std::find(begin, end, 0) != end)
  {
    options.exteriorLabel = 0;
  }
  ExtractJunctions(image, options, progress, input);
}
} // namespace tissue

#endif
