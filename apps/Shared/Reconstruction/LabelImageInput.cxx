/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/LabelImageInput.h"

#include "Shared/CommandLine/RunProgram.h"
#include "Shared/Images/ImageFileCheck.h"
#include "Shared/Images/ImageInput.h"
#include "Shared/Images/StandardErrorCapture.h"
#include "Shared/Images/WholeNumbers.h"
#include "Shared/Reconstruction/LabelSpecks.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkExteriorLabelImageCalculator.h"
#include "itkLabelGapClosingImageFilter.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

namespace tissue
{
namespace
{
bool
IsOfFloats(const itk::ImageIOBase * io)
{
  const auto type = io->GetComponentType();
  return type == itk::IOComponentEnum::FLOAT || type == itk::IOComponentEnum::DOUBLE;
}

/** Throws where the image, by its header, is no label image. */
void
RequireLabelImage(const itk::ImageIOBase * io)
{
  RequireVolume(io, "a label image");
  const auto type = io->GetComponentType();
  if (type == itk::IOComponentEnum::LDOUBLE || type == itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE)
  {
    throw std::runtime_error("the image has voxels of type " + itk::ImageIOBase::GetComponentTypeAsString(type) +
                             ", labels are integers");
  }
}

/** The labels of an image whose voxels are floats. */
template <typename TPixel>
WholeNumberImage::Pointer
ReadWholeNumbers(itk::ImageIOBase * io, const ImageOptions & options)
{
  return ToWholeNumbers(ReadImage<itk::Image<TPixel, 3>>(io, options).GetPointer(), IsScaled(io));
}

/** The labels of an image, in the type of its voxels; those of floats become whole numbers of 64 bits. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
ReadLabels(itk::ImageIOBase * io, const ImageOptions & options)
{
  if constexpr (std::is_same_v<TPixel, WholeNumberImage::PixelType>)
  {
    if (io->GetComponentType() == itk::IOComponentEnum::FLOAT)
    {
      return ReadWholeNumbers<float>(io, options);
    }
    if (io->GetComponentType() == itk::IOComponentEnum::DOUBLE)
    {
      return ReadWholeNumbers<double>(io, options);
    }
  }
  return ReadImage<itk::Image<TPixel, 3>>(io, options);
}

/** The exterior's labels, given or found in the image, 0 last unless it is a cell. */
template <typename TImage>
std::vector<Label>
FindExteriorLabels(const TImage * image, const itk::ExteriorLabelSettings & settings)
{
  std::vector<Label> labels = settings.labels;
  if (settings.isAutomatic)
  {
    const auto calculator = itk::ExteriorLabelImageCalculator<TImage>::New();
    calculator->SetImage(image);
    calculator->SetZeroIsCell(settings.zeroIsCell);
    calculator->Compute();
    labels = calculator->GetExteriorLabels();
  }
  if (!settings.zeroIsCell)
  {
    itk::ExteriorLabelSettings::Add(0, labels);
  }
  return labels;
}

/** Makes one label of all that is background, the first of the exterior's. Returns it. */
template <typename TImage>
typename TImage::PixelType
UniteBackground(TImage * image, const itk::ExteriorLabelSettings & settings)
{
  using PixelType = typename TImage::PixelType;
  PixelType * const        begin = image->GetBufferPointer();
  PixelType * const        end = begin + image->GetBufferedRegion().GetNumberOfPixels();
  const std::vector<Label> labels = FindExteriorLabels(image, settings);
  const auto               isFirst = [&](PixelType pixel) { return static_cast<Label>(pixel) == labels.front(); };
  if (labels.empty() || std::none_of(begin, end, isFirst))
  {
    throw std::runtime_error("there is no background to close gaps in: " +
                             (labels.empty()
                                ? std::string("no label of the image is the exterior's; --exteriorLabel tells it")
                                : "no voxel has the exterior label " + std::to_string(labels.front())));
  }
  const auto background = static_cast<PixelType>(labels.front());
  const auto isOther = [&](PixelType pixel) {
    return std::find(labels.begin() + 1, labels.end(), static_cast<Label>(pixel)) != labels.end();
  };
  std::replace_if(begin, end, isOther, background);
  return background;
}

template <typename TImage>
std::pair<typename TImage::Pointer, ClosedGaps>
CloseGaps(TImage * image, const LabelImageOptions & options, ProgressBar & progress)
{
  const auto background = UniteBackground(image, options.exterior);
  const auto closing = itk::LabelGapClosingImageFilter<TImage>::New();
  closing->SetInput(image);
  closing->SetGapWidth(*options.closeGaps);
  closing->SetBackgroundLabel(background);
  progress.Begin("Closing gaps");
  progress.Observe(closing);
  closing->Update();
  typename TImage::Pointer closed = closing->GetOutput();
  closed->DisconnectPipeline();
  return { closed,
           { closing->GetUsedGapWidth(),
             closing->GetNumberOfChangedVoxels(),
             closing->GetLargestDistance(),
             closing->GetShareOfGapsLeft(),
             closing->GetWidthOfGapsLeft() } };
}

template <typename TPixel>
LabelImage
ReadPixels(itk::ImageIOBase * io, const LabelImageOptions & options, ProgressBar & progress)
{
  using ImageType = itk::Image<TPixel, 3>;
  Stopwatch stopwatch;
  progress.Begin("Reading");
  StandardErrorCapture        messages;
  typename ImageType::Pointer image = ReadLabels<TPixel>(io, options.input);
  LabelImage                  result;
  result.file = options.file;
  result.warnings = JudgeMessages(messages.Release(), io);
  result.componentType = IsOfFloats(io) ? itk::IOComponentEnum::LONGLONG : io->GetComponentType();
  result.description =
    DescribeImage(image.GetPointer(), itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType()));
  result.description.unit = FindUnit(io, options.input);
  result.seconds.read = stopwatch.Lap().wallSeconds;
  if (options.closeGaps)
  {
    std::tie(image, result.closedGaps) = CloseGaps<ImageType>(image, options, progress);
    result.seconds.closeGaps = stopwatch.Lap().wallSeconds;
  }
  result.pixels = image;
  return result;
}
} // namespace

LabelImage
ReadLabelImage(const LabelImageOptions & options, ProgressBar & progress)
{
  return WithFileName(options.file, [&] {
    StandardErrorCapture            messages;
    const itk::ImageIOBase::Pointer io = OpenImage(options.file, options.input, ImageKind::Labels);
    std::vector<std::string>        warnings = JudgeMessages(messages.Release(), io);
    RequireLabelImage(io);
    RequireAllVoxels(options.file, io);
    LabelImage image = VisitPixelType(io->GetComponentType(),
                                      [&](auto zero) { return ReadPixels<decltype(zero)>(io, options, progress); });
    Append(image.warnings, warnings);
    Append(FindHeaderWarnings(io, options.input), warnings);
    image.warnings = warnings;
    return image;
  });
}

namespace
{
/** Of the image, without a look at its cells. \param speckVoxels the fewest of a label that may be specks. */
TissueInput
Extract(const LabelImage & image, const JunctionOptions & options, std::size_t speckVoxels, ProgressBar & progress)
{
  TissueInput input;
  input.file = image.file;
  input.image = image.description;
  input.closedGaps = image.closedGaps;
  input.warnings = image.warnings;
  input.seconds = image.seconds;
  input.extracted = VisitPixels(image, [&](const auto * pixels) {
    if (!options.acceptsSpecks)
    {
      RequireNoSpecks(pixels, speckVoxels);
    }
    return ExtractJunctions(pixels, options, progress);
  });
  if (!options.acceptsSpecks)
  {
    RequireFewPieces(input.GetJunctionSet());
  }
  return input;
}
} // namespace

TissueInput
ExtractTissue(const LabelImage & image, JunctionOptions options, ProgressBar & progress)
{
  if (image.closedGaps && options.exterior.labels.size() > 1)
  {
    // The closing has made one label of these.
    options.exterior.labels.resize(1);
  }
  return WithFileName(image.file, [&] {
    TissueInput         input = Extract(image, options, 1, progress);
    const JunctionSet & junctions = input.GetJunctionSet();
    Append(CheckExterior(junctions), input.warnings);
    Append(CheckSuspects(junctions), input.warnings);
    Append(CheckThatCellsTouch(junctions, input.closedGaps), input.warnings);
    Append(CheckClosedGaps(input.closedGaps), input.warnings);
    return input;
  });
}

TissueInput
ExtractCells(const LabelImage & image, ProgressBar & progress)
{
  // Markers of a voxel or two are cells here.
  constexpr std::size_t speckVoxels = 64;
  return WithFileName(image.file, [&] { return Extract(image, JunctionOptions(), speckVoxels, progress); });
}
} // namespace tissue
