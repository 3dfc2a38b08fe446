/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MembraneInput_h
#define MembraneInput_h

#include "TissueInput.h"

#include <itkImage.h>

namespace tissue
{
/** What is made of images of membranes and of points; 0 is the exterior. */
using TissueLabelImage = itk::Image<std::uint32_t, 3>;
using MembraneImage = itk::Image<float, 3>;

/** Reads an image of a scalar type; describes it and what is to be said of it in the input.
 * \param kind what it should be, as "an image of membranes".
 * \throws std::runtime_error or itk::ExceptionObject as ReadTissue(). */
MembraneImage::Pointer
ReadScalarImage(const std::string & path, const std::string & kind, TissueInput & input);

/** The cells of an image of membranes. \param cells where they are, about; null: the image's minima tell. */
TissueLabelImage::Pointer
SegmentMembranes(const MembraneImage * membranes, const TissueLabelImage * cells, const MembraneOptions & options,
                 ProgressBar & progress, TissueInput & input);

/** Reads the image of membranes of the options and extracts the junctions of the cells that its minima tell.
 * \throws std::runtime_error or itk::ExceptionObject as ReadTissue(). */
TissueInput
ReadMembranes(const TissueTessellationOptions & options, ProgressBar & progress);
} // namespace tissue

#endif
