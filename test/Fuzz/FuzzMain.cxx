/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "FuzzTargets.h"

// FUZZ_TARGET is the name of the target that this program feeds.
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t * bytes, std::size_t size)
{
  return tissue_test::FUZZ_TARGET(bytes, size);
}
