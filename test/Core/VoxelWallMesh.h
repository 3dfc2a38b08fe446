/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef VoxelWallMesh_h
#define VoxelWallMesh_h

#include "TissueTessellationCore/Mesh/WallMesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

/** \brief The wall mesh of a block of unit voxels, each of them filled with a vertex of the adjacency complex.
 *
 * Voxel (x, y, z) fills [x, x + 1] x [y, y + 1] x [z, z + 1]; `vertices` has x running fastest; around the block is the
 * exterior. Each face between different vertices makes two triangles; walls are in the order of their cells. */
inline tissue::WallMesh
MakeVoxelWallMesh(const std::array<int, 3> & size, const std::vector<tissue::VertexId> & vertices)
{
  using Position = std::array<int, 3>;
  const auto vertexAt = [&](const Position & voxel) {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (voxel[axis] < 0 || voxel[axis] >= size[axis])
      {
        return tissue::ExteriorVertex;
      }
    }
    return vertices[voxel[0] + size[0] * (voxel[1] + size[1] * voxel[2])];
  };
  const auto forEachPosition = [&](const auto & visit) {
    for (int z = 0; z <= size[2]; ++z)
    {
      for (int y = 0; y <= size[1]; ++y)
      {
        for (int x = 0; x <= size[0]; ++x)
        {
          visit(Position{ { x, y, z } });
        }
      }
    }
  };

  using Triangle = std::array<Position, 3>;
  std::map<tissue::VertexPair, std::vector<Triangle>> trianglesOfWall;
  forEachPosition([&](const Position & upper) {
    for (int axis = 0; axis < 3; ++axis)
    {
      Position lower = upper;
      --lower[axis];
      tissue::VertexPair cells{ { vertexAt(lower), vertexAt(upper) } };
      if (cells[0] == cells[1])
      {
        continue;
      }
      // The face runs counter-clockwise seen from the upper voxel, so its normal points there.
      std::array<Position, 4> face{ { upper, upper, upper, upper } };
      ++face[1][(axis + 1) % 3];
      ++face[2][(axis + 1) % 3];
      ++face[2][(axis + 2) % 3];
      ++face[3][(axis + 2) % 3];
      if (cells[0] == tissue::ExteriorVertex || (cells[1] != tissue::ExteriorVertex && cells[1] < cells[0]))
      {
        std::swap(cells[0], cells[1]);
        std::swap(face[1], face[3]);
      }
      trianglesOfWall[cells].push_back({ { face[0], face[1], face[2] } });
      trianglesOfWall[cells].push_back({ { face[0], face[2], face[3] } });
    }
  });

  tissue::WallMesh                    mesh;
  std::map<Position, tissue::PointId> idOfPosition;
  const auto                          pointAt = [&](const Position & p) {
    const auto inserted = idOfPosition.emplace(p, static_cast<tissue::PointId>(mesh.points.size()));
    if (inserted.second)
    {
      std::set<tissue::VertexId> around;
      for (int corner = 0; corner < 8; ++corner)
      {
        around.insert(vertexAt({ { p[0] - (corner & 1), p[1] - (corner >> 1 & 1), p[2] - (corner >> 2) } }));
      }
      mesh.points.push_back({ { double(p[0]), double(p[1]), double(p[2]) } });
      mesh.numberOfCells.push_back(static_cast<std::uint8_t>(around.size()));
    }
    return inserted.first->second;
  };
  for (const auto & wall : trianglesOfWall)
  {
    for (const Triangle & triangle : wall.second)
    {
      mesh.triangles.push_back({ { pointAt(triangle[0]), pointAt(triangle[1]), pointAt(triangle[2]) } });
      mesh.wallOfTriangle.push_back(static_cast<tissue::WallId>(mesh.walls.size()));
    }
    mesh.walls.push_back({ wall.first });
  }
  return mesh;
}

#endif
