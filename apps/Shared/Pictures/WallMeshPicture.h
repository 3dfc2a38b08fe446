/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef WallMeshPicture_h
#define WallMeshPicture_h

#include "Shared/Pictures/ColorScale.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <optional>
#include <string>
#include <vector>

namespace tissue
{
struct WallMeshPictureOptions
{
  /** In pixels, 64 to 4096. */
  int width = 1600;
  int height = 900;
  /** Name of the image's unit of length, UTF-8, for the scale bar. */
  std::string lengthUnit = "µm";
  /** What the cells are coloured by, with a legend; otherwise each has a colour of its own. */
  std::optional<PictureValues> values;
};

/** \brief Renders a tissue to a PNG file: cut open on the left, with its cells drawn apart on the right.
 *
 * From the tissue on the left the cells are left out whose centres lie in the quarter that is turned to the viewer; on
 * the right each cell is moved away from the tissue's centre, its size unchanged. Both are at one scale, in parallel
 * projection, with one scale bar. Up is the axis of space that the tissue's rounded tip points to, so that a meristem
 * stands upright. Triple lines are drawn dark. Without values no two neighbours have a similar colour. The same input
 * gives the same bytes on the same machine.
 *
 * \throws std::runtime_error where FindPictureObstacle() has something to say, where the mesh has no
 * triangle, where a size is out of its range, and where the file cannot be written; std::invalid_argument as
 * RequireConsistentIndices does. */
void
WriteWallMeshPicture(const WallMesh & mesh, const std::vector<Cell> & cells, const std::string & path,
                     const WallMeshPictureOptions & options = WallMeshPictureOptions());
} // namespace tissue

#endif
