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
  /** Nothing: it is found in the image. */
  std::optional<Label> exteriorLabel;
  bool                 zeroIsCell = false;
  ImageOptions         input;
  /** Widest gap to close, in the image's units; 0 for the automatic width; nothing: none is closed. */
  std::optional<double> closeGaps;
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

/** The tissue of a label image.
 * \throws FileError: fewer than four cells, an absent exterior label, cells that do not touch. */
TissueInput
ExtractTissue(const LabelImage & image, const JunctionOptions & options, ProgressBar & progress);
} // namespace tissue

#endif
