/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CellRemark_h
#define TissueTessellationCore_CellRemark_h

#include "TissueTessellationCore/Common/Types.h"

#include <string>
#include <vector>

namespace tissue
{
struct AdjacencyTuples;
struct CellSurfaceCheck;
struct JunctionSet;

/** What a user should know of one cell: what the image, not the method, made special or impossible. */
enum class Remark
{
  /** The cell has stray pieces; only its largest piece gives its centre. Value: voxels in the others. */
  SeveralPieces,
  /** The label may be no cell, by its size, its exterior, or its pieces: Suspicion. Value: as there. */
  SuspectLarge,
  SuspectPocket,
  SuspectPieces,
  /** The border of the image may cut the cell. */
  CutByBorder,
  /** The cell has one neighbour in the image: it is enclosed in it. Value: the neighbour's label. */
  Enclosed,
  /** The cell touches no other cell in the image, only the exterior. */
  Separated,
  /** A piece of the cell apart from its largest one has a closed surface of its own in the mesh. Value: its voxels. */
  Fragment,
  /** A piece of the cell is too small for a surface of its own. Value: its voxels. */
  FragmentDropped,
  /** The cell has walls that are rings, or have no corner, and was taken for several pieces while the complex was made;
   * the mesh has these walls as the image has them. Value: the number of pieces. */
  RingWalls,
  /** The cell's walls were joined or cut by a false wall so that its surface is one sphere. Value: the number of such
   * repairs. */
  Repaired,
  /** Voxels of the cell went to its neighbours, as they closed a handle: by which its surface is a sphere. Value: the
   * number of such voxels. */
  HandlesCut,
  /** The cell is a ring, or has several handles, in the image, and its surface in the mesh has them too. Value: the
   * number of handles. */
  HandlesKept,
  /** The cell has holes of background in the image, which enclosed nothing else, and keeps them. Value: their number.
   */
  Cavities,
  /** The cell has holes of background in the image, too small for a surface of their own, and is without them in the
   * mesh. Value: their number. */
  CavitiesFilled,
  /** Its centre was another cell's too, and was moved aside. Value: the distance in the image's units. */
  CenterMoved,
  /** The cell touches the exterior in the image, but not in the mesh. */
  ExteriorLost,
  /** The cell touches the exterior in the mesh, but not in the image. */
  ExteriorGained,
  /** Value: the number of the cell's walls in the image that are not in the mesh. */
  WallsLost,
  /** Value: the number of the cell's walls in the mesh that are not in the image. */
  WallsGained,
  /** The cell's volume in the mesh is below half or above twice that in the image: few corners and straight walls do
   * not describe it. Value: the volume in the mesh over that in the image; negative for a cell turned inside out. */
  VolumeOff,
  /** Corners of the cell that are at the mean of their neighbours, as the image has none there. Value: their number. */
  CornersNotFitted,
  /** The cell's volume in a mesh that is fitted to the image is more than 1 % off, as its walls would cross others.
   * Value: as of VolumeOff. */
  VolumeNotFitted,
  /** The walls of the mesh are those of the voxels, rough, as fitted ones of this cell crossed others or turned it
   * inside out. Value: the number of such places. */
  VoxelWalls,
  /** Places of the cell's walls are sharper than AngleLimits and could not be mended: small angles of triangles or
   * between them, or short edges. Value: their number. */
  Sharp,
  /** The cell has no triangle in the mesh: CellSurfaceCheck tells, not the reconstruction. */
  Missing,
  /** The cell's surface in the mesh is no closed sphere; likewise. Value: its Euler characteristic. */
  NoClosedSphere
};

inline constexpr int NumberOfRemarks = static_cast<int>(Remark::NoClosedSphere) + 1;

struct CellRemark
{
  VertexId cell;
  Remark   remark;
  double   value;
};

/** One word, stable, for reports: "severalPieces" and so on. */
const char *
ToString(Remark remark);

/** A sentence for a person, without its subject, the cell: "lost 2 walls that the image has". */
std::string
Describe(const CellRemark & remark);

/** What several cells have in common, to be put after their number: "without some wall that they have in the image". */
const char *
DescribeSeveral(Remark remark);

/** All remarks that follow from the image and the final complex, ascending by cell, then by kind. */
std::vector<CellRemark>
CollectRemarks(const AdjacencyTuples & complex, const JunctionSet & junctions);

/** The remarks on cells that are missing, then on those that are no closed spheres, in a mesh. */
std::vector<CellRemark>
CollectRemarks(const CellSurfaceCheck & check);
} // namespace tissue

#endif
