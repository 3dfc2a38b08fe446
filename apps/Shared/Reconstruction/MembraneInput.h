/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MembraneInput_h
#define MembraneInput_h

#include "Shared/Images/ScalarImageInput.h"
#include "Shared/Reconstruction/TissueInput.h"

#include <itkImage.h>

namespace tissue
{
/** What is made of images of membranes and of points; 0 is the exterior. */
using TissueLabelImage = itk::Image<std::uint32_t, 3>;

/** Reads the image of a stain; describes it and what is to be said of it in the input. \throws FileError. */
ScalarImage::Pointer
ReadStain(const std::string & path, TissueInput & input);

/** The cells of an image of membranes. \param cells where they are, about; null: the image's minima tell. */
TissueLabelImage::Pointer
SegmentMembranes(const ScalarImage * membranes, const TissueLabelImage * cells, const MembraneOptions & options,
                 ProgressBar & progress, TissueInput & input);

/** Reads the image of membranes of the options and extracts the junctions of the cells that its minima tell.
 * \throws std::runtime_error or itk::ExceptionObject as ReadTissue(). */
TissueInput
ReadMembranes(const ReconstructionOptions & options, ProgressBar & progress);
} // namespace tissue

#endif
