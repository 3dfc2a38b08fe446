/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImageVoids_h
#define TissueTessellationCore_ImageVoids_h

#include "TissueTessellationCore/Image/LabelVolume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tissue
{
/** A piece of the exterior, of voxels that hang together by faces, which one cell alone has faces with. */
struct ImageVoid
{
  VertexId cell = ExteriorVertex;
  /** The first of its voxels in the order of the image. */
  std::array<std::int32_t, 3> first = { { 0, 0, 0 } };
  std::int64_t                voxels = 0;
};

/** The voids within single cells, in the order of their first voxels. None touches the border of the image, as all that
 * is outside of it is exterior. */
std::vector<ImageVoid>
FindVoidsInCells(const LabelVolume & volume);
} // namespace tissue

#endif
