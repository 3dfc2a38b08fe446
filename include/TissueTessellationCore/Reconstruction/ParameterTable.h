/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_ParameterTable_h
#define TissueTessellationCore_ParameterTable_h

#include "TissueTessellationCore/Reconstruction/ReconstructionParameters.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tissue
{
/** The numbers that a parameter may be: from the least to the most, both included. */
struct ParameterRange
{
  double least;
  double most;
  /** Whether 0, which then stands for a choice of its own, is allowed beside them. */
  bool orZero = false;

  /** False for what is no number. */
  bool
  Contains(double value) const
  {
    return (value >= least && value <= most) || (orZero && value == 0.0);
  }
};

/** The place of a parameter in the parameters. */
template <typename TValue>
using ParameterMember = TValue & (*)(ReconstructionParameters &);

struct RealParameter
{
  ParameterMember<double> member;
  ParameterRange          range;
};

struct IntegerParameter
{
  ParameterMember<int> member;
  ParameterRange       range;
};

/** The range is that of an option: above it a number of a JSON report may be read as another. Check() takes every seed.
 */
struct SeedParameter
{
  ParameterMember<std::uint64_t> member;
  ParameterRange                 range;
};

struct BooleanParameter
{
  ParameterMember<bool> member;
};

/** One of several values of an enumeration, each of which has a name for the user. */
struct EnumerationParameter
{
  /** Names in alphabetical order, with the enumeration's values as numbers. */
  std::vector<std::pair<std::string, int>> values;
  int (*getValue)(ReconstructionParameters);
  void (*setValue)(ReconstructionParameters &, int);

  std::vector<std::string>
  GetNames() const;

  /** \throws std::invalid_argument for a name that is none of the values'. */
  void
  Set(ReconstructionParameters & parameters, const std::string & name) const;
};

/** Who meets a parameter, beside programmers. */
enum class ParameterUse
{
  /** Users, who choose it by an option; the report has it. */
  Option,
  /** Readers of the report, which has it among what is fixed. */
  Fixed,
  /** Nobody. */
  Internal
};

/** \brief All that is to be known of one parameter of the reconstruction. Its default is that of the preset. */
struct Parameter
{
  /** Unique; it names the parameter in errors and where an ITK filter is printed. */
  std::string name;
  /** Unique; the name of the option, without its dashes, and in the report. */
  std::string  option;
  ParameterUse use;
  /** The way to the complex that knows it; nothing: both. */
  std::optional<ComplexSource> source;
  /** What it is, for a user. */
  std::string words;

  std::variant<RealParameter, IntegerParameter, SeedParameter, BooleanParameter, EnumerationParameter> kind;
};

/** \brief The parameters of ReconstructionParameters, in the order of the options: Check(), the options of the
 * programs, their report and the print of the ITK filters are made of it. */
const std::vector<Parameter> &
GetParameterTable();

/** Whether it makes a difference by the parameters' way to the complex. */
bool
IsUsed(const Parameter & parameter, const ReconstructionParameters & parameters);

/** Of an enumeration the name of the value. */
using ParameterValue = std::variant<bool, int, double, std::uint64_t, std::string>;

ParameterValue
GetValue(const Parameter & parameter, const ReconstructionParameters & parameters);

/** For a person: "true", "150", "combinatorial". */
std::string
ToString(const ParameterValue & value);

/** What is wrong with the parameter's value, to be put after a name: "is 4, must be in 0 .. 3". Empty if nothing is. */
std::string
FindFault(const Parameter & parameter, const ReconstructionParameters & parameters);
} // namespace tissue

#endif
