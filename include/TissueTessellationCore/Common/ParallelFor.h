/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ParallelFor_h
#define TissueTessellationCore_ParallelFor_h

#include <cstddef>
#include <functional>

namespace tissue
{
/** Calls the body with 0 ... count - 1, each once, in any order and from any thread; returns when all are done. The
 * core has no threads: who has some passes them in. Empty: one after the other. */
using ParallelFor = std::function<void(std::size_t count, const std::function<void(std::size_t)> & body)>;

/** Runs the body as ParallelFor says. What runs in parallel may not depend on the order. */
inline void
RunFor(const ParallelFor & parallelFor, std::size_t count, const std::function<void(std::size_t)> & body)
{
  if (parallelFor)
  {
    parallelFor(count, body);
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    body(i);
  }
}
} // namespace tissue

#endif
