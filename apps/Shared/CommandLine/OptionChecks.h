/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OptionChecks_h
#define OptionChecks_h

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <vector>

namespace tissue
{
/** A range that, unlike CLI11's, is printed short and refuses what is no number. */
CLI::Validator
InRange(double least, double most);

/** The extension of a file to write, or one of several. */
CLI::Validator
EndsIn(const std::vector<std::string> & extensions);
CLI::Validator
EndsIn(const std::string & extension);

/** The values of options by their names, "--preset". */
using FoundOptions = std::map<std::string, std::string>;

/** Those of the named options, of one value each, that are on the command line, whatever else is there: what other
 * options there are, and their defaults, may depend on them.
 * \throws CLI::Error where an option has no value, or is there twice. */
FoundOptions
FindOptions(const std::vector<std::string> & names, int argc, char ** argv);

/** Parses the command line; a flag that may have a number, "--flag=2", may have it as the next argument, too, "--flag
 * 2". False after --help and the like, which have then been answered. \throws std::runtime_error that names the option
 * and what is wrong with it. */
bool
Parse(CLI::App & app, int argc, char ** argv);
} // namespace tissue

#endif
