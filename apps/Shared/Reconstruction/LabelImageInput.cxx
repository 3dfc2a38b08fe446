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
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkExteriorLabelImageCalculator.h"
#include "itkLabelGapClosingImageFilter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace tissue
{
namespace
{
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

/** What there is to doubt of the voxels' size. */
std::vector<std::string>
CheckSpacing(const itk::ImageIOBase * io, const std::array<double, 3> & spacing)
{
  // Some formats hold the inverse of the spacing, in single precision.
  const auto isOne = [](double length) { return std::abs(length - 1.0) < 1e-6; };
  if (std::all_of(spacing.begin(), spacing.end(), isOne))
  {
    return { "the voxels are exactly 1 x 1 x 1: the file may have lost its voxel size, which shapes and "
             "volumes depend on; --spacing X Y Z gives it" };
  }
  if (std::string(io->GetNameOfClass()) == "TIFFImageIO")
  {
    return { "a TIFF file holds no distance of its slices, which is taken for 1; --spacing X Y Z gives "
             "the voxel size" };
  }
  return {};
}

/** The exterior's label, given or found in the image; nothing where the image has none. */
template <typename TImage>
std::optional<Label>
FindExteriorLabel(const TImage * image, const LabelImageOptions & options)
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
UniteBackground(TImage * image, const LabelImageOptions & options)
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
std::pair<typename TImage::Pointer, ClosedGaps>
CloseGaps(TImage * image, const LabelImageOptions & options, ProgressBar & progress)
{
  const auto background = UniteBackground(image, options);
  const auto closing = itk::LabelGapClosingImageFilter<TImage>::New();
  closing->SetInput(image);
  closing->SetGapWidth(*options.closeGaps);
  closing->SetBackgroundLabel(background);
  progress.Begin("Closing gaps");
  progress.Observe(closing);
  closing->Update();
  typename TImage::Pointer closed = closing->GetOutput();
  closed->DisconnectPipeline();
  return { closed, { closing->GetUsedGapWidth(), closing->GetNumberOfChangedVoxels(), closing->GetLargestDistance() } };
}

template <typename TPixel>
LabelImage
ReadPixels(const itk::ImageIOBase * io, const LabelImageOptions & options, ProgressBar & progress)
{
  using ImageType = itk::Image<TPixel, 3>;
  Stopwatch stopwatch;
  progress.Begin("Reading");
  StandardErrorCapture        messages;
  typename ImageType::Pointer image = ReadImage<ImageType>(options.file, options.spacing);
  LabelImage                  result;
  result.file = options.file;
  result.warnings = JudgeMessages(messages.Release(), io);
  result.componentType = io->GetComponentType();
  result.description =
    DescribeImage(image.GetPointer(), itk::ImageIOBase::GetComponentTypeAsString(result.componentType));
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
    const itk::ImageIOBase::Pointer io = OpenImage(options.file);
    std::vector<std::string>        warnings = JudgeMessages(messages.Release(), io);
    RequireLabelImage(io);
    RequireAllVoxels(options.file, io);
    LabelImage image = VisitPixelType(io->GetComponentType(),
                                      [&](auto zero) { return ReadPixels<decltype(zero)>(io, options, progress); });
    Append(image.warnings, warnings);
    if (!options.spacing)
    {
      Append(CheckSpacing(io, image.description.spacing), warnings);
    }
    image.warnings = warnings;
    return image;
  });
}

TissueInput
ExtractTissue(const LabelImage & image, const JunctionOptions & options, ProgressBar & progress)
{
  return WithFileName(image.file, [&] {
    TissueInput input;
    input.file = image.file;
    input.image = image.description;
    input.closedGaps = image.closedGaps;
    input.warnings = image.warnings;
    input.seconds = image.seconds;
    input.extracted =
      VisitPixels(image, [&](const auto * pixels) { return ExtractJunctions(pixels, options, progress); });
    Append(CheckThatCellsTouch(input.GetJunctionSet(), input.closedGaps), input.warnings);
    return input;
  });
}
} // namespace tissue
