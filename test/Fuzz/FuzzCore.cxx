/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FuzzTargets.h"
#include "TissueTessellationCore/Points/PointJunctions.h"
#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "VoxelTissue.h"

#include <stdexcept>

namespace tissue_test
{
int
FuzzLabelImage(const std::uint8_t * bytes, std::size_t size)
{
  constexpr std::size_t headerSize = 4;
  constexpr int         longestSide = 6;
  if (size < headerSize)
  {
    return 0;
  }
  LabelVolume volume;
  std::size_t number = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    volume.size[axis] = 1 + bytes[axis] % longestSide;
    number *= static_cast<std::size_t>(volume.size[axis]);
  }
  // Vertices are numbered without gaps.
  const int               numberOfLabels = 1 + bytes[3] % 16;
  std::map<int, VertexId> vertexOf;
  const auto              labelAt = [&](std::size_t i) {
    return size > headerSize ? bytes[headerSize + i % (size - headerSize)] % numberOfLabels : 0;
  };
  for (std::size_t i = 0; i < number; ++i)
  {
    labelAt(i) > 0 ? void(vertexOf[labelAt(i)] = 0) : void();
  }
  VertexId last = ExteriorVertex;
  for (auto & entry : vertexOf)
  {
    entry.second = ++last;
  }
  volume.vertices = VoxelVertices(number, ExteriorVertex);
  for (std::size_t i = 0; i < number; ++i)
  {
    labelAt(i) > 0 ? volume.vertices.Put(i, vertexOf[labelAt(i)]) : void();
  }
  try
  {
    ReconstructionParameters parameters;
    parameters.refinement = 0;
    ReconstructTissue(JunctionsOf(volume), parameters, &volume);
  }
  catch (const std::invalid_argument &)
  {
    // Images without cells are refused so.
  }
  return 0;
}

int
FuzzPoints(const std::uint8_t * bytes, std::size_t size)
{
  constexpr std::size_t mostPoints = 30;
  constexpr std::size_t bytesOfPoint = 6;
  std::vector<Point>    points;
  std::vector<Label>    labels;
  for (std::size_t i = 0; i < std::min(mostPoints, size / bytesOfPoint); ++i)
  {
    const auto coordinate = [&](std::size_t axis) {
      const std::uint8_t * const at = bytes + bytesOfPoint * i + 2 * axis;
      // A whole number, or one with a tiny fraction.
      return static_cast<double>(at[0] % 16) + (at[1] > 128 ? 1e-12 * at[1] : at[1] / 128.0);
    };
    points.push_back({ { coordinate(0), coordinate(1), coordinate(2) } });
    labels.push_back(static_cast<Label>(i + 1));
  }
  try
  {
    ReconstructTissue(MakePointJunctions(points, labels), ReconstructionParameters::PaperPointsPreset());
  }
  catch (const std::invalid_argument &)
  {
    // Too few points, all in a plane.
  }
  return 0;
}
} // namespace tissue_test
