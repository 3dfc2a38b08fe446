/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LabelInput_h
#define LabelInput_h

#include "PeerMeshers.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <string>

namespace tissue
{
using LabelImage = itk::Image<std::int32_t, 3>;

/** \throws itk::ExceptionObject where there is no such file, or it is no image that ITK reads. */
LabelImage::Pointer
ReadLabels(const std::string & path);

using LabelExtraction = itk::LabelJunctionExtractionFilter<LabelImage>;

/** The filter after its update, with default parameters but that it makes the label volume, too. \throws
 * itk::ExceptionObject as the filter does. */
LabelExtraction::Pointer
ExtractTissue(const LabelImage * labels);

/** Labels that are none of the cells become the exterior. */
CellImage::Pointer
MakeCellImage(const LabelImage * labels, const std::vector<Cell> & cells);

/** The image as the evaluation reads it, in the space of the peers' meshes. */
LabelVolume
MakePeerVolume(const CellImage * image);
} // namespace tissue

#endif
