/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef FourCubes_h
#define FourCubes_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Statistics/TissueStatistics.h"
#include "VoxelWallMesh.h"

/** \brief Four unit cubes around the edge x = y = 1, in a tissue whose labels have gaps.
 *
 * By hand: 18 points, of which the 2 ends of the edge have 5 cells, 8 have 3 and the 8 corners of the block 2; 4 walls
 * to the exterior of 8 triangles and area 4, 4 walls between two cubes of 2 triangles and area 1. */
struct FourCubes
{
  tissue::WallMesh          mesh = MakeVoxelWallMesh({ { 2, 2, 1 } }, { 1, 2, 3, 4 });
  std::vector<tissue::Cell> cells = std::vector<tissue::Cell>(5);

  FourCubes()
  {
    cells[0].label = 7;
    for (int v = 1; v < 5; ++v)
    {
      cells[v].label = 10 * v;
      cells[v].center = { { (v - 1) % 2 + 0.5, (v - 1) / 2 + 0.5, 0.5 } };
      cells[v].volume = 0.875;
      cells[v].numberOfVoxels = 1000 + v;
      cells[v].touchesExterior = true;
    }
    cells[3].touchesBorder = true;
    cells[4].numberOfPieces = 3;
    cells[4].numberOfStrayVoxels = 5;
  }

  tissue::TissueStatistics
  Statistics() const
  {
    return tissue::MeasureTissue(mesh, cells, tissue::ImageGrid());
  }
};

#endif
