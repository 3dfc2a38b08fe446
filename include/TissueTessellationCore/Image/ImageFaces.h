/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImageFaces_h
#define TissueTessellationCore_ImageFaces_h

#include "TissueTessellationCore/Image/LabelVolume.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <vector>

namespace tissue
{
/** \brief Places in a label image, in physical space, by the wall or line that they are of. */
class ImagePlaces
{
public:
  using Place = std::array<float, 3>;

  struct Entry
  {
    std::size_t group;
    Place       place;
  };

  ImagePlaces(std::size_t numberOfGroups, const std::vector<Entry> & entries);

  const Place *
  Begin(std::size_t group) const
  {
    return m_Places.data() + m_First[group];
  }

  const Place *
  End(std::size_t group) const
  {
    return m_Places.data() + m_First[group + 1];
  }

private:
  std::vector<std::size_t> m_First;
  std::vector<Place>       m_Places;
};

/** The centres of the voxel faces between the two cells of each wall. */
ImagePlaces
CollectImageFaces(const LabelVolume & volume, const std::vector<WallMesh::Wall> & walls);

/** The centres of the voxel edges at which the three cells of each line meet; `lines` ascending, each line ascending,
 * all different. */
ImagePlaces
CollectImageLines(const LabelVolume & volume, const std::vector<VertexTriple> & lines);
} // namespace tissue

#endif
