/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_WallFaces_h
#define TissueTessellationCore_WallFaces_h

#include "Image/ImagePlaces.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

namespace tissue
{
/** \brief The voxel faces of each wall of a mesh, by their centres.
 *
 * Where two vertices have several walls their faces are taken apart into pieces that hang together by edges of voxels.
 * A wall's outline tells its piece: that of the face nearest to most of its points. Pieces that no outline tells go to
 * the nearest wall, and the faces of one that several tell to the nearest of these.
 *
 * \param volume the image by the vertices of the complex.
 * \param pairs the two vertices of each wall of the mesh, in any order. */
ImagePlaces
CollectWallFaces(const WallMesh & mesh, const std::vector<VertexPair> & pairs, const LabelVolume & volume);
} // namespace tissue

#endif
