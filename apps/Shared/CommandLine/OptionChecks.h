/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OptionChecks_h
#define OptionChecks_h

#include <CLI/CLI.hpp>

#include <string>

namespace tissue
{
/** A range that, unlike CLI11's, is printed short and refuses what is no number. */
CLI::Validator
InRange(double least, double most);

/** The extension of a file to write. */
CLI::Validator
EndsIn(const std::string & extension);

/** Parses the command line; false after --help and --version, which have then been answered.
 * \throws std::runtime_error that names the option and what is wrong with it. */
bool
Parse(CLI::App & app, int argc, char ** argv);
} // namespace tissue

#endif
