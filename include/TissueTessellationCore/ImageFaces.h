/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImageFaces_h
#define TissueTessellationCore_ImageFaces_h

#include "TissueTessellationCore/LabelVolume.h"
#include "TissueTessellationCore/ParallelFor.h"
#include "TissueTessellationCore/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief The voxel faces of a label image by the walls of a mesh: the centre of each, in physical space. */
class ImageFaces
{
public:
  using Center = std::array<float, 3>;

  ImageFaces(const LabelVolume & volume, const std::vector<WallMesh::Wall> & walls);

  const Center *
  Begin(WallId wall) const
  {
    return m_Centers.data() + m_First[wall];
  }

  const Center *
  End(WallId wall) const
  {
    return m_Centers.data() + m_First[wall + 1];
  }

private:
  std::vector<std::size_t> m_First;
  std::vector<Center>      m_Centers;
};
} // namespace tissue

#endif
