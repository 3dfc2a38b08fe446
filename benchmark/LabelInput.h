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

/** Reads a label image. \throws itk::ExceptionObject where there is no such file, or it is not an image that ITK reads.
 */
LabelImage::Pointer
ReadLabels(const std::string & path);

using LabelExtraction = itk::LabelJunctionExtractionFilter<LabelImage>;

/** Returns the filter after its update, with default parameters but that it makes the label volume, too. \throws
 * itk::ExceptionObject as the filter does. */
LabelExtraction::Pointer
ExtractTissue(const LabelImage * labels);

/** Makes the image of vertices that the peers are given. Labels that are none of the cells' become the exterior. */
CellImage::Pointer
MakeCellImage(const LabelImage * labels, const std::vector<Cell> & cells);

/** Makes the volume that the evaluation reads of an image of vertices, in the space of the peers' meshes. */
LabelVolume
MakePeerVolume(const CellImage * image);
} // namespace tissue

#endif
