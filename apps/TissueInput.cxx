/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueInput.h"

#include "TissueTessellationCore/SeparatedCells.h"
#include <itkChangeInformationImageFilter.h>
#include <itkImageFileReader.h>
#include <itkTimeProbe.h>
#include <itksys/SystemTools.hxx>

#include "itkLabelGapClosingImageFilter.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
constexpr unsigned int Dimension = 3;
/** Labels named in a message; the report has them all. */
constexpr std::size_t NamedLabels = 10;

itk::ImageIOBase::Pointer
ReadHeader(const std::string & path)
{
  if (!itksys::SystemTools::FileExists(path, true))
  {
    throw std::runtime_error("no such file: " + path);
  }
  const itk::ImageIOBase::Pointer io =
    itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::ImageIOFactory::IOFileModeEnum::ReadMode);
  if (!io)
  {
    throw std::runtime_error("not an image in a format that ITK reads: " + path);
  }
  io->SetFileName(path);
  io->ReadImageInformation();
  const auto require = [&path](bool isMet, const std::string & found, const std::string & needed) {
    if (!isMet)
    {
      throw std::runtime_error(path + " has " + found + "; " + needed);
    }
  };
  // A trailing axis of one voxel is how some formats write fewer dimensions.
  unsigned int dimensions = io->GetNumberOfDimensions();
  while (dimensions > 1 && io->GetDimensions(dimensions - 1) == 1)
  {
    --dimensions;
  }
  require(dimensions == Dimension, std::to_string(dimensions) + " dimensions", "a label image has 3");
  require(io->GetNumberOfComponents() == 1,
          std::to_string(io->GetNumberOfComponents()) + " components a voxel",
          "a label image has 1");
  const auto type = io->GetComponentType();
  require(type != itk::IOComponentEnum::FLOAT && type != itk::IOComponentEnum::DOUBLE &&
            type != itk::IOComponentEnum::LDOUBLE && type != itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE,
          "pixels of type " + itk::ImageIOBase::GetComponentTypeAsString(type),
          "labels are integers");
  return io;
}

std::string
NameLabels(const std::vector<VertexId> & cells, const JunctionSet & junctions)
{
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(cells.size(), NamedLabels); ++i)
  {
    text << (i > 0 ? ", " : "") << junctions.cells[cells[i]].label;
  }
  text << (cells.size() > NamedLabels ? ", ..." : "");
  return text.str();
}

void
CheckThatCellsTouch(const JunctionSet & junctions, std::vector<std::string> & warnings)
{
  const std::vector<VertexId> separated = FindSeparatedCells(junctions);
  if (separated.empty())
  {
    return;
  }
  const std::size_t numberOfCells = junctions.cells.size() - 1;
  const std::string message = std::to_string(separated.size()) + " of " + std::to_string(numberOfCells) +
                              " cells touch no other cell though others are near (labels " +
                              NameLabels(separated, junctions) + "): a wall of background lies between them";
  if (2 * separated.size() > numberOfCells)
  {
    throw std::runtime_error(message + "; --closeGaps grows the labels over such walls");
  }
  warnings.push_back(message);
}

/** Seconds since the last call or the start. */
class Stopwatch
{
public:
  Stopwatch() { m_Probe.Start(); }

  double
  Lap()
  {
    m_Probe.Stop();
    const double seconds = m_Probe.GetTotal();
    m_Probe.Reset();
    m_Probe.Start();
    return seconds;
  }

private:
  itk::TimeProbe m_Probe;
};

template <typename TImage>
typename TImage::Pointer
ReadImage(const TissueTessellationOptions & options)
{
  const auto reader = itk::ImageFileReader<TImage>::New();
  reader->SetFileName(options.labels);
  const auto information = itk::ChangeInformationImageFilter<TImage>::New();
  information->SetInput(reader->GetOutput());
  if (options.spacing)
  {
    information->ChangeSpacingOn();
    information->SetOutputSpacing(itk::Vector<double, Dimension>(options.spacing->data()));
  }
  information->Update();
  typename TImage::Pointer image = information->GetOutput();
  image->DisconnectPipeline();
  return image;
}

template <typename TImage>
typename TImage::Pointer
CloseGaps(TImage * image, const TissueTessellationOptions & options, ProgressBar & progress, TissueInput & input)
{
  const auto closing = itk::LabelGapClosingImageFilter<TImage>::New();
  closing->SetInput(image);
  closing->SetGapWidth(*options.closeGaps);
  closing->SetBackgroundLabel(static_cast<typename TImage::PixelType>(options.exteriorLabel.value_or(0)));
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
Process(const TissueTessellationOptions & options, ProgressBar & progress, TissueInput & input)
{
  using ImageType = itk::Image<TPixel, Dimension>;
  Stopwatch stopwatch;
  progress.Begin("Reading");
  typename ImageType::Pointer image = ReadImage<ImageType>(options);
  input.readSeconds = stopwatch.Lap();
  for (unsigned int axis = 0; axis < Dimension; ++axis)
  {
    input.size[axis] = image->GetLargestPossibleRegion().GetSize(axis);
    input.spacing[axis] = image->GetSpacing()[axis];
  }

  if (options.closeGaps)
  {
    image = CloseGaps<ImageType>(image, options, progress, input);
    input.closeGapsSeconds = stopwatch.Lap();
  }

  const auto extraction = itk::LabelJunctionExtractionFilter<ImageType>::New();
  extraction->SetInput(image);
  if (options.exteriorLabel)
  {
    extraction->SetExteriorLabel(*options.exteriorLabel);
  }
  extraction->SetZeroIsCell(options.zeroIsCell);
  progress.Begin("Finding junctions");
  progress.Observe(extraction);
  extraction->Update();
  input.exteriorLabel = extraction->GetUsedExteriorLabel();
  input.junctions = extraction->GetOutput();
  input.junctions->DisconnectPipeline();
  input.extractSeconds = stopwatch.Lap();
}
} // namespace

TissueInput
ReadTissue(const TissueTessellationOptions & options, ProgressBar & progress)
{
  const itk::ImageIOBase::Pointer io = ReadHeader(options.labels);
  TissueInput                     input;
  input.pixelType = itk::ImageIOBase::GetComponentTypeAsString(io->GetComponentType());
  switch (io->GetComponentType())
  {
    case itk::IOComponentEnum::UCHAR:
      Process<unsigned char>(options, progress, input);
      break;
    case itk::IOComponentEnum::CHAR:
      Process<signed char>(options, progress, input);
      break;
    case itk::IOComponentEnum::USHORT:
      Process<unsigned short>(options, progress, input);
      break;
    case itk::IOComponentEnum::SHORT:
      Process<short>(options, progress, input);
      break;
    case itk::IOComponentEnum::UINT:
      Process<unsigned int>(options, progress, input);
      break;
    case itk::IOComponentEnum::INT:
      Process<int>(options, progress, input);
      break;
    case itk::IOComponentEnum::ULONG:
    case itk::IOComponentEnum::ULONGLONG:
      Process<unsigned long long>(options, progress, input);
      break;
    default:
      Process<long long>(options, progress, input);
  }
  if (input.spacing == std::array<double, 3>{ 1.0, 1.0, 1.0 } && !options.spacing)
  {
    input.warnings.push_back(
      "the voxels are exactly 1 x 1 x 1: the file may have lost its voxel size, which shapes and "
      "volumes depend on; --spacing X Y Z gives it");
  }
  CheckThatCellsTouch(input.junctions->GetJunctionSet(), input.warnings);
  return input;
}
} // namespace tissue
