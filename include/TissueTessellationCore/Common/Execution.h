/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Execution_h
#define TissueTessellationCore_Execution_h

#include <cstddef>
#include <functional>
#include <stdexcept>

namespace tissue
{
/** Told the fraction of the whole that is done, in 0 .. 1, ascending; returns false to stop. May be empty. */
using ProgressFunction = std::function<bool(double)>;

/** Thrown where a ProgressFunction asked to stop. */
class Aborted : public std::runtime_error
{
public:
  Aborted()
    : std::runtime_error("aborted on request")
  {}
};

/** Reports a fraction.
 * \throws Aborted where the function returns false. */
inline void
Report(const ProgressFunction & progress, double fraction)
{
  if (progress && !progress(fraction))
  {
    throw Aborted();
  }
}

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
