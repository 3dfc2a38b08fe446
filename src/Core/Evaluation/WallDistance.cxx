/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Evaluation/WallDistance.h"

#include "Image/ImagePlaces.h"
#include "Mesh/WallPieces.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>

namespace tissue
{
WallDistance
MeasureWallDistance(const WallMesh & walls, VertexId numberOfVertices, const LabelVolume & labels,
                    const Execution & execution)
{
  struct Sums
  {
    double area = 0.0;
    double distance = 0.0;
    double falseArea = 0.0;
  };
  const ImagePlaces              faces = CollectImageFaces(labels, CellsOfWalls(walls));
  const std::vector<std::size_t> first = FirstTrianglesOfWalls(walls);
  std::vector<Sums>              sumsOfWall(walls.walls.size());
  execution.For(walls.walls.size(), [&](std::size_t w) {
    const PlaceTree       places(faces.Begin(w), faces.End(w));
    const AreaAndDistance sums = IntegrateDistance(walls.points, walls.triangles, first[w], first[w + 1], places);
    sumsOfWall[w] = places.IsEmpty() ? Sums{ 0.0, 0.0, sums.area } : Sums{ sums.area, sums.distance, 0.0 };
  });

  WallDistance        result;
  Sums                total;
  std::vector<double> areaOfVertex(static_cast<std::size_t>(numberOfVertices), 0.0);
  result.ofVertex.assign(static_cast<std::size_t>(numberOfVertices), 0.0);
  for (std::size_t w = 0; w < walls.walls.size(); ++w)
  {
    total.area += sumsOfWall[w].area;
    total.distance += sumsOfWall[w].distance;
    total.falseArea += sumsOfWall[w].falseArea;
    for (const VertexId v : walls.walls[w].cells)
    {
      if (v < numberOfVertices)
      {
        areaOfVertex[v] += sumsOfWall[w].area;
        result.ofVertex[v] += sumsOfWall[w].distance;
      }
    }
  }
  for (std::size_t v = 0; v < areaOfVertex.size(); ++v)
  {
    result.ofVertex[v] = areaOfVertex[v] > 0.0 ? result.ofVertex[v] / areaOfVertex[v] : -1.0;
  }
  const double whole = total.area + total.falseArea;
  result.mean = total.area > 0.0 ? total.distance / total.area : -1.0;
  result.voxelLength = labels.VoxelLength();
  result.shareOfFalseWalls = whole > 0.0 ? total.falseArea / whole : 0.0;
  return result;
}
} // namespace tissue
