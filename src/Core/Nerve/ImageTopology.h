/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ImageTopology_h
#define TissueTessellationCore_ImageTopology_h

#include "Nerve/HandleCutting.h"
#include "Nerve/ImageNerve.h"
#include "Nerve/KuhnFragments.h"
#include "Nerve/LabelDivision.h"
#include "Nerve/NerveRepair.h"
#include "Nerve/PlaceDescent.h"

#include <functional>

namespace tissue
{
struct ImageTopologyParameters
{
  PlacePreferences preferences = PlacePreferences::WallsFirst();
  /** Voxels from which on a fragment of a cell becomes a vertex of its own. Four, the fewest with a volume, lose no
   * more of the image's pairs of cells than must be; to mesh them well takes more. */
  std::int64_t minimumFragmentVoxels = 4;
  /** Votes on corners, of an image that is an estimate; they decide in place of its corners (PlaceEnergy.h). */
  std::vector<JunctionVote> votes;
  /** Whether the nerve is improved by moves; of an image of noise it is not worth the time. */
  bool descends = true;
};

/** \brief The complex of a label image, and all that was met on the way. */
struct ImageTopology
{
  /** The complex after repair and descent; its corners and lines lead to the image. */
  ImageNerve nerve;
  /** What the complex was measured by: of the image with its large fragments and the pieces of divided cells as
   * vertices of their own. */
  TissuePlaces places;
  Fragments    fragments;
  /** The cells that had handles before some voxels of theirs went to their neighbours. */
  std::vector<HandleCut> handles;
  /** The image by the vertices of the complex; without voxels where it is the image itself. */
  LabelVolume volume;
  /** Of each vertex of the complex the one of the image that it is a piece of: a cell, or the exterior. */
  std::vector<VertexId> cellOf;
  /** What was divided so that walls without corners are in the complex, and walls that are no disks. */
  std::vector<DividedCell>       divided;
  std::vector<NerveRepairRecord> repairs;
  PlaceDescentResult             descent;
  /** Cells whose links are not one sphere in the end: with handles, or without any place in the complex. */
  std::vector<VertexId> unsoundCells;
};

/** Called with the nerve before the repair; again where cells had to be divided after it. */
using NerveVisitor = std::function<void(const ImageTopology &)>;

/** Fragments, handles, nerve, division, repair and descent of an image whose voxels are of the vertices 0 ...
 * numberOfVertices - 1. The volume is as it was in the end; it is copied where cells have fragments or handles. */
ImageTopology
FindImageTopology(const LabelVolume & volume, VertexId numberOfVertices,
                  const ImageTopologyParameters & parameters = ImageTopologyParameters(),
                  const Execution & execution = Execution(), const NerveVisitor & visit = NerveVisitor());
} // namespace tissue

#endif
