/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueSamples_h
#define TissueTessellationCore_TissueSamples_h

#include "TissueTessellationCore/Common/Execution.h"
#include "TissueTessellationCore/Tessellation/AnisotropicTessellation.h"

#include <vector>

namespace tissue
{
/** Points of a tissue that are evenly spread and grouped into small balls. Each stands for a box about it. */
struct TissueSamples
{
  struct Group
  {
    Point       center = { { 0.0, 0.0, 0.0 } };
    double      radius = 0.0;
    std::size_t end = 0;
  };
  std::vector<Point> points;
  /** Each group holds the points from the end of the group before it to its own end. */
  std::vector<Group> groups;
  /** The sides of the boxes. */
  Point boxSize = { { 1.0, 1.0, 1.0 } };
};

/** Finds the nearest seed of every sample, in the order of the samples. */
std::vector<AnisotropicTessellation::SeedId>
AssignSamples(const AnisotropicTessellation & tessellation, const TissueSamples & samples,
              const Execution & execution = Execution());
} // namespace tissue

#endif
