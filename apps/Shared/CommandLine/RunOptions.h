/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RunOptions_h
#define RunOptions_h

#include "Shared/CommandLine/ProgressBar.h"

#include <CLI/CLI.hpp>

#include <string>

namespace tissue
{
/** How a program runs, whatever it does. */
struct RunOptions
{
  /** At most 1024; 0: all of the machine. */
  unsigned int threads = 0;
  bool         isQuiet = false;
  /** See ChooseProgressStyle(). */
  std::string progress = "auto";
  /** Whether a result with faults ends with StrictError. */
  bool isStrict = false;

  /** None where the program is to be quiet, unless progress is asked for. */
  ProgressStyle
  GetProgressStyle() const
  {
    return isQuiet && progress == "auto" ? ProgressStyle::None : ChooseProgressStyle(progress);
  }
};

/** All but --strict. */
void
AddRunOptions(CLI::App & app, RunOptions & options);

/** Of the programs that make meshes. */
void
AddStrictOption(CLI::App & app, RunOptions & options);

/** Lets ITK's filters use as many threads; 0: all of the machine. */
void
UseThreads(unsigned int threads);
} // namespace tissue

#endif
