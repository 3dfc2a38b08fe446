/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OptionType_h
#define OptionType_h

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** The number that a text is, all of it, as options take it; else nothing. */
std::optional<double>
FindNumber(const std::string & text);

/** \brief What the type name of an option tells, with that of its checks: "FLOAT:0 .. 1", "FILE:*.vtp", "TEXT:{a,b}".
 *
 * Integers are INT, UINT and NUMBER, other numbers FLOAT. Checks are InRange(), EndsIn() and CLI::IsMember; others are
 * passed over. */
struct OptionType
{
  explicit OptionType(const CLI::Option & option);

  /** Whether a number is in the range; so is each where there is none. */
  bool
  Contains(double value) const;

  /** Without the checks. */
  std::string              type;
  bool                     isReal = false;
  bool                     isInteger = false;
  std::vector<std::string> choices;
  /** Of a file to write, the first where there are several, ".vtp"; empty: none is asked for. */
  std::string           extension;
  std::optional<double> least;
  std::optional<double> most;

private:
  void
  AddCheck(const std::string & check);
};
} // namespace tissue

#endif
