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
    ->check(InRange(0, 1024))
    ->capture_default_str();
  app.add_flag("--quiet", options.isQuiet, "Say nothing but warnings and errors");
  app
    .add_option("--progress",
                options.progress,
                "On standard error: bar, lines (one a second at most), none; auto: a bar on a terminal; slicer: for 3D "
                "Slicer, on standard output")
    ->check(CLI::IsMember({ "auto", "bar", "lines", "none", "slicer" }))
    ->type_name("{auto,bar,lines,none,slicer}")
    ->capture_default_str();
}

void
AddStrictOption(CLI::App & app, RunOptions & options)
{
  app.add_flag("--strict",
               options.isStrict,
               "Exit with 2 where the mesh has faults: triangles that cross, cells that are no closed spheres, volumes "
               "more than 5 % off; files are written all the same");
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
