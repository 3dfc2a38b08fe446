/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/ImageFileCheck.h"
#include "Shared/Images/ImageInput.h"
#include "Shared/Images/StandardErrorCapture.h"
#include "Shared/Images/VisitPixelType.h"
#include "Shared/Reconstruction/JunctionInput.h"
#include "Shared/Reconstruction/TissueInput.h"
#include "TissueTessellationCore/Adjacency/SeparatedCells.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkExteriorLabelImageCalculator.h"
#include "itkLabelGapClosingImageFilter.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
constexpr unsigned int Dimension = 3;
/** Throws where the image, by its header, is no label image. */
void
RequireLabelImage(const itk::ImageIOBase * io)
{
  RequireVolume(io, "a label image");
  const auto type = io->GetComponentType();
  if (type == itk::IOComponentEnum::FLOAT || type == itk::IOComponentEnum::DOUBLE ||
      type == itk::IOComponentEnum::LDOUBLE || type == itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    throw std::runtime_error("the image has voxels of type " + itk::ImageIOBase::GetComponentTypeAsString(type) +
                             ", labels are integers");
  }
}

void
CheckSpacing(const itk::ImageIOBase * io, TissueInput & input)
{
  // Some formats hold the inverse of the spacing, in single precision.
  const auto isOne = [](double spacing) { return std::abs(spacing - 1.0) < 1e-6; };
  if (std::all_of(input.spacing.begin(), input.spacing.end(), isOne))
  {
    input.warnings.push_back(
      "the voxels are exactly 1 x 1 x 1: the file may have lost its voxel size, which shapes and "
      "volumes depend on; --spacing X Y Z gives it");
  }
  else if (std::string(io->GetNameOfClass()) == "TIFFImageIO")
  {
    input.warnings.push_back("a TIFF file holds no distance of its slices, which is taken for 1; --spacing X Y Z gives "
                             "the voxel size");
  }
}

/** The exterior's label, given or found in the image; nothing where the image has none. */
template <typename TImage>
std::optional<Label>
FindExteriorLabel(const TImage * image, const ReconstructionOptions & options)
{
  if (options.exteriorLabel)
  {
    return options.exteriorLabel;
  }
  const auto calculator = itk::ExteriorLabelImageCalculator<TImage>::New();
  calculator->SetImage(image);
  calculator->SetZeroIsCell(options.zeroIsCell);
  calculator->Compute();
  const bool isZero = !calculator->GetHasExteriorLabel() && !options.zeroIsCell;
  return calculator->GetHasExteriorLabel() || isZero ? std::optional<Label>(calculator->GetExteriorLabel())
                                                     : std::nullopt;
}

/** Makes one label of all that is background: the exterior's, and 0 unless it is a cell. Returns it. */
template <typename TImage>
typename TImage::PixelType
UniteBackground(TImage * image, const ReconstructionOptions & options)
{
  using PixelType = typename TImage::PixelType;
  PixelType * const          begin = image->GetBufferPointer();
  PixelType * const          end = begin + image->GetBufferedRegion().GetNumberOfPixels();
  const std::optional<Label> label = FindExteriorLabel(image, options);
  const auto                 isLabel = [&](PixelType pixel) { return static_cast<Label>(pixel) == *label; };
  if (!label || std::none_of(begin, end, isLabel))
  {
    throw std::runtime_error("there is no background to close gaps in: " +
                             (label
                                ? "no voxel has the exterior label " + std::to_string(*label)
                                : std::string("no label of the image is the exterior's; --exteriorLabel tells it")));
  }
  const auto background = static_cast<PixelType>(*label);
  if (!options.zeroIsCell)
  {
    std::replace(begin, end, PixelType{ 0 }, background);
  }
  return background;
}

template <typename TImage>
typename TImage::Pointer
CloseGaps(TImage * image, const ReconstructionOptions & options, ProgressBar & progress, TissueInput & input)
{
  const auto background = UniteBackground(image, options);
  const auto closing = itk::LabelGapClosingImageFilter<TImage>::New();
  closing->SetInput(image);
  closing->SetGapWidth(*options.closeGaps);
  closing->SetBackgroundLabel(background);
  progress.Begin("Closing gaps");
  progress.Observe(closing);
  closing->Update();
  input.closedGapWidth = closing->GetUsedGapWidth();
  input.numberOfClosedVoxels = closing->GetNumberOfChangedVoxels();
  input.largestClosedDistance = closing->GetLargestDistance();
  typename TImage::Pointer closed = closing->GetOutput();
  closed->DisconnectPipeline();
  return closed;
}

template <typename TPixel>
void
Process(const itk::ImageIOBase * io, const ReconstructionOptions & options, ProgressBar & progress, TissueInput & input)
{
  using ImageType = itk::Image<TPixel, Dimension>;
  Stopwatch stopwatch;
  progress.Begin("Reading");
  StandardErrorCapture        messages;
  typename ImageType::Pointer image = ReadImage<ImageType>(options.labels, options.spacing);
  for (const std::string & warning : JudgeMessages(messages.Release(), io))
  {
    input.warnings.push_back(warning);
  }
  input.readSeconds = stopwatch.Lap().wallSeconds;
  DescribeImage(image.GetPointer(), input);

  if (options.closeGaps)
  {
    image = CloseGaps<ImageType>(image, options, progress, input);
    input.closeGapsSeconds = stopwatch.Lap().wallSeconds;
  }

  ExtractJunctions(image.GetPointer(), options, progress, input);
  if (options.keepsImage)
  {
    input.image = image;
  }
}
} // namespace

std::string
NameLabels(const std::vector<Label> & labels)
{
  constexpr std::size_t most = 10;
  std::ostringstream    text;
  for (std::size_t i = 0; i < std::min(labels.size(), most); ++i)
  {
    text << (i > 0 ? ", " : "") << labels[i];
  }
  text << (labels.size() > most ? ", ..." : "");
  return text.str();
}

void
CheckThatCellsTouch(const JunctionSet & junctions, const ReconstructionOptions & options, TissueInput & input)
{
  const std::vector<VertexId> separated = FindSeparatedCells(junctions);
  if (separated.empty())
  {
    return;
  }
  std::vector<Label> labels;
  for (const VertexId cell : separated)
  {
    labels.push_back(junctions.cells[cell].label);
  }
  const std::size_t numberOfCells = junctions.cells.size() - 1;
  const std::string message = std::to_string(separated.size()) + " of " + std::to_string(numberOfCells) +
                              " cells touch no other cell though others are near (labels " + NameLabels(labels) +
                              "): a wall of background lies between them";
  if (2 * separated.size() > numberOfCells)
  {
    std::ostringstream help;
    if (options.closeGaps)
    {
      help << ", wider than the gaps that --closeGaps has closed, of " << input.closedGapWidth;
    }
    else
    {
      help << "; --closeGaps grows the labels over such walls";
    }
    throw std::runtime_error(message + help.str());
  }
  input.warnings.push_back(message);
}

TissueInput
ReadTissue(const ReconstructionOptions & options, ProgressBar & progress)
{
  TissueInput                     input;
  StandardErrorCapture            messages;
  const itk::ImageIOBase::Pointer io = OpenImage(options.labels);
  input.warnings = JudgeMessages(messages.Release(), io);
  RequireLabelImage(io);
  RequireAllVoxels(options.labels, io);
  input.pixelType = itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType());
  input.componentType = io->GetComponentType();
  VisitPixelType(input.componentType, [&](auto zero) { Process<decltype(zero)>(io, options, progress, input); });
  if (!options.spacing)
  {
    CheckSpacing(io, input);
  }
  CheckThatCellsTouch(input.junctions->GetJunctionSet(), options, input);
  return input;
}
} // namespace tissue
