/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/RunOptions.h"

#include "Shared/CommandLine/OptionChecks.h"

#include <itkMultiThreaderBase.h>

namespace tissue
{
void
AddRunOptions(CLI::App & app, RunOptions & options)
{
  app.add_option("--threads", options.threads, "Threads; 0: all cores. The result does not depend on it")
    ->check(InRange(0, 1024));
  app.add_flag("--quiet", options.isQuiet, "Say nothing but warnings and errors");
}

void
UseThreads(unsigned int threads)
{
  if (threads > 0)
  {
    itk::MultiThreaderBase::SetGlobalMaximumNumberOfThreads(threads);
    itk::MultiThreaderBase::SetGlobalDefaultNumberOfThreads(threads);
  }
}
} // namespace tissue
