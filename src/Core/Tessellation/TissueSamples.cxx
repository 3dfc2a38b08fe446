/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Tessellation/TissueSamples.h"

#include <algorithm>

namespace tissue
{
std::vector<AnisotropicTessellation::SeedId>
AssignSamples(const AnisotropicTessellation & tessellation, const TissueSamples & samples, const Execution & execution)
{
  using SeedId = AnisotropicTessellation::SeedId;
  // A group is small, so that a thread takes many at a time; its ball tells which seeds its samples have to be compared
  // with.
  constexpr std::size_t groupsAtATime = 256;
  std::vector<SeedId>   cells(samples.points.size());
  execution.For((samples.groups.size() + groupsAtATime - 1) / groupsAtATime, [&](std::size_t batch) {
    const std::size_t   last = std::min((batch + 1) * groupsAtATime, samples.groups.size());
    std::vector<SeedId> candidates;
    for (std::size_t g = batch * groupsAtATime; g < last; ++g)
    {
      const TissueSamples::Group & group = samples.groups[g];
      tessellation.FindCandidates(group.center, group.radius, candidates);
      for (std::size_t i = g > 0 ? samples.groups[g - 1].end : 0; i < group.end; ++i)
      {
        cells[i] = tessellation.FindNearest(samples.points[i], candidates);
      }
    }
  });
  return cells;
}
} // namespace tissue
