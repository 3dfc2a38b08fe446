/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RunOptions_h
#define RunOptions_h

#include <CLI/CLI.hpp>

namespace tissue
{
/** How a program runs, whatever it does. */
struct RunOptions
{
  /** At most 1024; 0: all of the machine. */
  unsigned int threads = 0;
  bool         isQuiet = false;
};

void
AddRunOptions(CLI::App & app, RunOptions & options);

/** Lets ITK's filters use as many threads; 0: all of the machine. */
void
UseThreads(unsigned int threads);
} // namespace tissue

#endif
