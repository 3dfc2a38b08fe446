/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef JunctionInput_h
#define JunctionInput_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <algorithm>

namespace tissue
{
/** How a label image is understood, and what is extracted from it. */
struct JunctionOptions
{
  itk::ExteriorLabelSettings exterior;
  /** Whether the labels are wanted too, for walls that are fitted to them. */
  bool makesVolume = false;
  /** Whether an image whose labels are specks is taken for a label image all the same. */
  bool acceptsSpecks = false;
  /** On which cells of an estimated tissue meet; null: none. */
  itk::TissueVotes::ConstPointer votes;
};

/** The junctions of a label image. \throws itk::ExceptionObject as itk::LabelJunctionExtractionFilter. */
template <typename TImage>
ExtractedJunctions
ExtractJunctions(const TImage * image, const JunctionOptions & options, ProgressBar & progress)
{
  Stopwatch  timer;
  const auto extraction = itk::LabelJunctionExtractionFilter<TImage>::New();
  extraction->SetInput(image);
  extraction->SetVotes(options.votes);
  extraction->SetExterior(options.exterior);
  extraction->SetGenerateLabelVolume(options.makesVolume);
  progress.Begin("Finding junctions");
  progress.Observe(extraction);
  extraction->Update();
  ExtractedJunctions extracted;
  extracted.exteriorLabel = extraction->GetUsedExteriorLabel();
  extracted.droppedLabels = extraction->GetUsedDroppedLabels();
  extracted.junctions = extraction->GetOutput();
  extracted.junctions->DisconnectPipeline();
  if (options.makesVolume)
  {
    extracted.volume = extraction->GetLabelVolume();
    extracted.volume->DisconnectPipeline();
  }
  extracted.seconds = timer.Lap().wallSeconds;
  return extracted;
}

/** Likewise of a label image that we have made, whose exterior is 0 where it has one. */
template <typename TImage>
ExtractedJunctions
ExtractTissueJunctions(const TImage * image, JunctionOptions options, ProgressBar & progress)
{
  const auto * const begin = image->GetBufferPointer();
  const auto * const end = begin + image->GetBufferedRegion().GetNumberOfPixels();
  if (std::find(begin, end, 0) != end)
  {
    options.exterior.labels = { 0 };
    options.exterior.isAutomatic = false;
  }
  return ExtractJunctions(image, options, progress);
}
} // namespace tissue

#endif
