/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueInput_h
#define TissueInput_h

#include "itkTissueJunctions.h"
#include "itkTissueLabelVolume.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** What is to be said of an image. */
struct ImageDescription
{
  /** Of the file; empty where there is none. */
  std::string pixelType;
  /** 0 where no voxels are known. */
  std::array<std::size_t, 3> size{};
  std::array<double, 3>      spacing{};
  /** Of the spacing, "micrometres"; empty where it is not known. */
  std::string unit;
};

/** What became of the gaps between the cells. Widths and distances are in the image's units. */
struct ClosedGaps
{
  double      width = 0.0;
  std::size_t numberOfVoxels = 0;
  double      largestDistance = 0.0;
  /** Of the places where two cells are next to each other, the share that is still apart, and by how much: see
   * itk::LabelGapClosingImageFilter. */
  double shareLeft = 0.0;
  double widthLeft = 0.0;
};

/** How deep the minima of an image of membranes are that were taken for cells. */
struct MembraneMinima
{
  /** Standard deviation, as estimated, in the image's units. */
  double noise = 0.0;
  /** The least depth, over the range of intensities. */
  double depth = 0.0;
};

/** Times on the wall of the steps that led to the labels. */
struct InputSeconds
{
  double read = 0.0;
  double closeGaps = 0.0;
  double segment = 0.0;
};

/** What is extracted from a label image. */
struct ExtractedJunctions
{
  itk::TissueJunctions::Pointer junctions;
  /** The labels that the walls are fitted to; none if they are not. */
  itk::TissueLabelVolume::Pointer volume;
  Label                           exteriorLabel = 0;
  /** Those that were taken for exterior though they are no background. */
  std::vector<Label> droppedLabels;
  /** Time on the wall that it took. */
  double seconds = 0.0;
};

/** \brief The cells of a tissue as the programs take them, from an image or from points, and what is to be said of
 * where they come from. */
struct TissueInput
{
  /** The file that the cells are from. */
  std::string        file;
  ExtractedJunctions extracted;
  /** Of the file of points; 0 for an image. */
  std::size_t numberOfPoints = 0;
  /** Of the points' coordinates, as their file says it; empty where it does not. */
  std::string pointUnit;
  /** Of the labels, where the file of points has names. */
  std::map<Label, std::string> names;
  ImageDescription             image;
  /** Nothing unless they were to be closed. */
  std::optional<ClosedGaps> closedGaps;
  /** Nothing unless the cells are such minima. */
  std::optional<MembraneMinima> membraneMinima;
  std::vector<std::string>      warnings;
  InputSeconds                  seconds;

  const JunctionSet &
  GetJunctionSet() const
  {
    return extracted.junctions->GetJunctionSet();
  }
};

template <typename TImage>
ImageDescription
DescribeImage(const TImage * image, const std::string & pixelType)
{
  ImageDescription description;
  description.pixelType = pixelType;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    description.size[axis] = image->GetLargestPossibleRegion().GetSize(axis);
    description.spacing[axis] = image->GetSpacing()[axis];
  }
  return description;
}

/** Adds warnings to those that there are. */
void
Append(const std::vector<std::string> & more, std::vector<std::string> & warnings);

/** The first labels of a list, for a message; the report has them all. */
std::string
NameLabels(const std::vector<Label> & labels);

/** A warning of cells that touch no other though others are near; nothing where there are none.
 * \throws std::runtime_error where most cells are such. */
std::vector<std::string>
CheckThatCellsTouch(const JunctionSet & junctions, const std::optional<ClosedGaps> & closedGaps);
/** A warning where no voxel of the image is exterior, with the label that covers most of its border. */
std::vector<std::string>
CheckExterior(const JunctionSet & junctions);

/** A warning of labels that may be no cells. */
std::vector<std::string>
CheckSuspects(const JunctionSet & junctions);

/** A warning of gaps that remain where they were closed: in a twentieth or more of the places where cells are next to
 * each other. */
std::vector<std::string>
CheckClosedGaps(const std::optional<ClosedGaps> & closedGaps);
} // namespace tissue

#endif
