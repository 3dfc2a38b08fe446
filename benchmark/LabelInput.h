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
#include "itkTissueJunctions.h"

#include <string>

namespace tissue
{
using LabelImage = itk::Image<std::int32_t, 3>;

/** Reads a label image. \throws itk::ExceptionObject where there is no such file, or it is not an image that ITK reads.
 */
LabelImage::Pointer
ReadLabels(const std::string & path);

/** Extracts the junctions with the filter's default parameters. \throws itk::ExceptionObject as the filter does. */
itk::TissueJunctions::Pointer
ExtractJunctions(const LabelImage * labels);

/** Makes the image of vertices that the peers are given. Labels that are none of the cells' become the exterior. */
CellImage::Pointer
MakeCellImage(const LabelImage * labels, const std::vector<Cell> & cells);

/** Makes the volume that the evaluation reads of an image of vertices, in the space of the peers' meshes. */
LabelVolume
MakePeerVolume(const CellImage * image);
} // namespace tissue

#endif
