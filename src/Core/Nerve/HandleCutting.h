/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_HandleCutting_h
#define TissueTessellationCore_HandleCutting_h

#include "Nerve/PlaneScan.h"
#include "Nerve/PlaceUpdate.h"
#include "Nerve/VoxelBox.h"

#include <atomic>

namespace tissue
{
/** A cell that has handles in the image. */
struct HandleCut
{
  VertexId     cell;
  std::int32_t handlesBefore;
  /** As before where a cut would take too much, or would give other cells more handles than it takes. */
  std::int32_t handlesLeft;
  /** That the cell gives to its neighbours. */
  std::int64_t numberOfVoxels;
};

/** What cuts the handles of cells. */
struct HandleCuts
{
  std::vector<HandleCut> cells;
  /** Of the volume, each voxel once, in raster order. */
  std::vector<VoxelChange> changes;
};

/** \brief Finds the cells that have handles in the Kuhn subdivision of the grid, in which they would have no spheres
 * for links, and the voxels that make balls of them: thin sheets across the handles where these are thinnest.
 *
 * Most handles of a segmentation are a matter of single voxels. A cell grows anew from its deepest voxel, the deepest
 * first, by voxels that leave it a ball (simple points: their neighbours in the ball are connected, and so are the
 * others); what is left cuts the handles. Each connected part of it goes to the vertex that it has most faces with. No
 * more than a twenty-fifth of a cell's voxels, or eight, are taken: what needs more, as a scaffold does, is left as
 * it is. Cavities in cells stay, as do the handles of the exterior. The cost is that of the cells concerned.
 *
 * \param volume each of its vertices but the exterior is one piece (FindFragments()); it gets the cuts.
 * \param characteristics of the volume's vertices, by FindEulerCharacteristics(); only where one is not 1 can there be
 *        a handle.
 * \param boxes of the volume's vertices, which may be larger than need be. */
HandleCuts
CutHandles(LabelVolume & volume, std::vector<std::int32_t> characteristics, std::vector<VoxelBox> boxes);

/** \brief Adds up the Euler characteristics of the regions of all vertices from the blocks that it is shown, in any
 * order: those in which there is something to know (PlaneScan.h). */
class EulerGathering
{
public:
  explicit EulerGathering(VertexId numberOfVertices)
    : m_Sums(static_cast<std::size_t>(numberOfVertices))
  {}

  void
  Add(const CrowdedBlock & block);

  /** As of FindEulerCharacteristics(). */
  std::vector<std::int32_t>
  GetCharacteristics() const;

private:
  std::vector<std::atomic<std::int32_t>> m_Sums;
};

/** The Euler characteristic of each vertex's region in the Kuhn subdivision, pieces - handles + cavities; 0 for the
 * exterior, which has no end. */
std::vector<std::int32_t>
FindEulerCharacteristics(const LabelVolume & volume, VertexId numberOfVertices,
                         const Execution & execution = Execution());
} // namespace tissue

#endif
