/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LabelImageInput_h
#define LabelImageInput_h

#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/Images/ImageOptions.h"
#include "Shared/Images/VisitPixelType.h"
#include "Shared/Reconstruction/JunctionInput.h"
#include "Shared/Reconstruction/TissueInput.h"

#include <itkImage.h>

namespace tissue
{
/** A label image, and how it is to be understood. */
struct LabelImageOptions
{
  std::string file;
  /** Which labels are the exterior; found in the image by default. */
  itk::ExteriorLabelSettings exterior;
  ImageOptions               input;
  /** Widest gap to close, in the image's units; 0 for the automatic width; nothing: none is closed. */
  std::optional<double> closeGaps;
  /** See JunctionOptions. */
  bool acceptsSpecks = false;
};

/** A label image that was read, its gaps closed if they were to be. */
struct LabelImage
{
  std::string file;
  /** An itk::Image of the pixels that VisitPixelType() gives of the component type. */
  itk::DataObject::ConstPointer pixels;
  itk::IOComponentEnum          componentType = itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE;
  ImageDescription              description;
  std::optional<ClosedGaps>     closedGaps;
  std::vector<std::string>      warnings;
  InputSeconds                  seconds;
};

/** Calls visit with the image, of its own type, and returns what that returns. */
template <typename TVisitor>
auto
VisitPixels(const LabelImage & image, const TVisitor & visit)
{
  return VisitPixelType(image.componentType, [&](auto zero) {
    return visit(dynamic_cast<const itk::Image<decltype(zero), 3> *>(image.pixels.GetPointer()));
  });
}

/** Reads labels of an integer type, or of floats that are whole numbers, see ToWholeNumbers().
 * \throws FileError: as OpenImage(), cut off, not three-dimensional, more than one component, not whole numbers; no
 * background to close gaps in. */
LabelImage
ReadLabelImage(const LabelImageOptions & options, ProgressBar & progress);

/** The tissue of a label image, with a warning where no label is the exterior's, where labels may be no cells, where
 * some cells touch no other, and where gaps remain that were to be closed.
 * \throws FileError: no cell, an absent label that was named, labels that are specks, cells of which most touch no
 * other. */
TissueInput
ExtractTissue(const LabelImage & image, JunctionOptions options, ProgressBar & progress);

/** The cells of a label image, which need not touch each other, with the warnings of reading it.
 * \throws FileError: no cell; labels of many voxels each that are specks. */
TissueInput
ExtractCells(const LabelImage & image, ProgressBar & progress);
} // namespace tissue

#endif
