/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RunBackwards_h
#define RunBackwards_h

#include "TissueTessellationCore/Common/Execution.h"

namespace tissue_test
{
using tissue::Execution;

/** Runs from the last to the first. */
inline void
RunBackwards(std::size_t count, const Execution::LoopBody & body)
{
  while (count > 0)
  {
    body(--count);
  }
}
} // namespace tissue_test

#endif
