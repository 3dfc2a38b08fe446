/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueInput_h
#define TissueInput_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Reconstruction/ReconstructionOptions.h"
#include "itkTissueJunctions.h"
#include "itkTissueLabelVolume.h"

#include <itkCommonEnums.h>

namespace tissue
{
/** A label image as the program takes it: its junctions, and what is to be said of it. */
struct TissueInput
{
  itk::TissueJunctions::Pointer junctions;
  /** The labels that the walls are fitted to; none if they are not. */
  itk::TissueLabelVolume::Pointer volume;
  /** The image itself, of the pixels that VisitPixelType() gives of the component type; none unless it is kept. */
  itk::DataObject::ConstPointer image;
  itk::IOComponentEnum          componentType = itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  /** Of the file of points; 0 for an image. */
  std::size_t                numberOfPoints = 0;
  std::string                pixelType;
  std::array<std::size_t, 3> size{};
  std::array<double, 3>      spacing{};
  Label                      exteriorLabel = 0;
  std::vector<std::string>   warnings;

  /** Of the gaps closed; 0 without. Widths and distances are in the image's units. */
  double      closedGapWidth = 0.0;
  std::size_t numberOfClosedVoxels = 0;
  double      largestClosedDistance = 0.0;

  double readSeconds = 0.0;
  double closeGapsSeconds = 0.0;
  double segmentSeconds = 0.0;
  double extractSeconds = 0.0;
};

/** The first labels of a list, for a message; the report has them all. */
std::string
NameLabels(const std::vector<Label> & labels);

/** Adds a warning for cells that touch no other though others are near. \throws std::runtime_error where most do. */
void
CheckThatCellsTouch(const JunctionSet & junctions, const ReconstructionOptions & options, TissueInput & input);

/** Reads the image and extracts its junctions.
 * \throws std::runtime_error or itk::ExceptionObject: no such file, not readable, cut off, not three-dimensional, more
 * than one component, not of an integer type, fewer than four cells, an absent exterior label, cells that do not touch.
 */
TissueInput
ReadTissue(const ReconstructionOptions & options, ProgressBar & progress);
} // namespace tissue

#endif
