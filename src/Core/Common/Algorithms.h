/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Algorithms_h
#define TissueTessellationCore_Algorithms_h

#include "TissueTessellationCore/Common/Execution.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tissue
{
/** The median of one or more values; of an even number the upper one. */
inline double
Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Sorts values and leaves each once. */
template <typename TValue>
void
SortUnique(std::vector<TValue> & values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/** Returns those of 0 ... count - 1 for which the test holds, ascending. The test may be called from any thread. */
template <typename TTest>
std::vector<std::size_t>
Select(std::size_t count, const TTest & test, const Execution & execution)
{
  // One call of the loop tests this many numbers: enough to outweigh the call, few enough to keep all threads busy.
  constexpr std::size_t                 chunk = 4096;
  std::vector<std::vector<std::size_t>> found((count + chunk - 1) / chunk);
  execution.For(found.size(), [&](std::size_t c) {
    for (std::size_t i = c * chunk; i < std::min(count, (c + 1) * chunk); ++i)
    {
      if (test(i))
      {
        found[c].push_back(i);
      }
    }
  });
  std::vector<std::size_t> all;
  for (const auto & part : found)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
} // namespace tissue

#endif
