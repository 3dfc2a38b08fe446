/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Progress_h
#define TissueTessellationCore_Progress_h

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
} // namespace tissue

#endif
