/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Median_h
#define TissueTessellationCore_Median_h

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
} // namespace tissue

#endif
