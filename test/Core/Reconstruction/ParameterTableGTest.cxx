/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Reconstruction/ParameterTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

namespace
{
using namespace tissue;

const ReconstructionParameters Presets[] = { ReconstructionParameters(),
                                             ReconstructionParameters::PaperPreset(),
                                             ReconstructionParameters::PaperPointsPreset() };

std::string
ErrorOf(const ReconstructionParameters & parameters)
{
  try
  {
    parameters.Check();
  }
  catch (const std::invalid_argument & error)
  {
    return error.what();
  }
  return "none";
}

/** What Check() says of a value of the parameter. */
template <typename TNumber, typename TValue>
std::string
ErrorOf(const TNumber & number, TValue value)
{
  ReconstructionParameters parameters;
  number.member(parameters) = value;
  return ErrorOf(parameters);
}

/** Expects that both ends of the range are taken, and that what is beyond them is refused. */
template <typename TNumber, typename TValue>
void
ExpectRange(const Parameter & parameter, const TNumber & number, TValue below, TValue above)
{
  EXPECT_EQ(ErrorOf(number, static_cast<TValue>(number.range.least)), "none") << parameter.name;
  EXPECT_EQ(ErrorOf(number, static_cast<TValue>(number.range.most)), "none") << parameter.name;
  for (const TValue value : { below, above })
  {
    std::ostringstream expected;
    expected << parameter.name << " is " << static_cast<double>(value) << ", must be in " << number.range.least
             << " .. " << number.range.most;
    EXPECT_EQ(ErrorOf(number, value), expected.str());
  }
}

const Parameter &
Find(const std::string & name)
{
  const auto & table = GetParameterTable();
  return *std::find_if(table.begin(), table.end(), [&name](const Parameter & p) { return p.name == name; });
}
} // namespace

TEST(ParameterTable, HasUniqueNamesAndOptionsAndWordsForAll)
{
  std::set<std::string> names;
  std::set<std::string> options;
  for (const Parameter & parameter : GetParameterTable())
  {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name;
    EXPECT_TRUE(options.insert(parameter.option).second) << parameter.option;
    EXPECT_FALSE(parameter.words.empty()) << parameter.name;
  }
}

TEST(ParameterTable, HasThePresetsInItsRanges)
{
  for (const ReconstructionParameters & preset : Presets)
  {
    EXPECT_EQ(ErrorOf(preset), "none");
    for (const Parameter & parameter : GetParameterTable())
    {
      EXPECT_EQ(FindFault(parameter, preset), "") << parameter.name;
      EXPECT_NE(ToString(GetValue(parameter, preset)), "unknown") << parameter.name;
      if (const auto * const seed = std::get_if<SeedParameter>(&parameter.kind))
      {
        EXPECT_TRUE(seed->range.Contains(static_cast<double>(preset.annealing.seed)));
      }
    }
  }
}

TEST(ParameterTable, TellsWhatTheWayToTheComplexUses)
{
  const ReconstructionParameters ofImage;
  const auto                     ofCenters = ReconstructionParameters::PaperPreset();
  EXPECT_TRUE(IsUsed(Find("prefer"), ofImage));
  EXPECT_FALSE(IsUsed(Find("prefer"), ofCenters));
  EXPECT_FALSE(IsUsed(Find("seed"), ofImage));
  EXPECT_TRUE(IsUsed(Find("seed"), ofCenters));
  EXPECT_TRUE(IsUsed(Find("refinement"), ofImage) && IsUsed(Find("refinement"), ofCenters));
}

TEST(ParameterTable, IsWhatCheckRefusesBy)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Parameter & parameter : GetParameterTable())
  {
    if (const auto * const real = std::get_if<RealParameter>(&parameter.kind))
    {
      ExpectRange(parameter, *real, real->range.least - 1.0, 2.0 * real->range.most);
      ExpectRange(parameter, *real, -infinity, infinity);
      EXPECT_EQ(ErrorOf(*real, std::nan("")).find(parameter.name + " is nan, must be in "), 0u);
    }
    else if (const auto * const integer = std::get_if<IntegerParameter>(&parameter.kind))
    {
      const auto least = static_cast<int>(integer->range.least);
      const auto most = static_cast<int>(integer->range.most);
      ExpectRange(parameter, *integer, least - 1, most + 1);
    }
  }
}

TEST(ParameterTable, HasZeroAsAChoiceBesideARange)
{
  const auto & unitLength = std::get<RealParameter>(Find("unitLength").kind);
  EXPECT_TRUE(unitLength.range.orZero);
  EXPECT_EQ(ErrorOf(unitLength, 0.0), "none");
  EXPECT_EQ(ErrorOf(unitLength, 1e-13), "unitLength is 1e-13, must be in 1e-12 .. 1e+12");
}

TEST(ParameterTable, ReadsAndNamesValuesOfAnyKind)
{
  ReconstructionParameters parameters;
  parameters.annealing.seed = 18446744073709551615u;
  const auto text = [&parameters](const std::string & name) { return ToString(GetValue(Find(name), parameters)); };
  EXPECT_EQ(text("trianglesPerCell"), "150");
  EXPECT_EQ(text("refinement"), "1");
  EXPECT_EQ(text("fitToImage"), "true");
  EXPECT_EQ(text("seed"), "18446744073709551615");
  EXPECT_EQ(text("legality"), "geometric");
  EXPECT_EQ(ErrorOf(parameters), "none") << "every seed is good";
}

TEST(ParameterTable, SetsEnumerationsByTheNamesOfTheirValues)
{
  int number = 0;
  for (const Parameter & parameter : GetParameterTable())
  {
    if (const auto * const enumeration = std::get_if<EnumerationParameter>(&parameter.kind))
    {
      const auto names = enumeration->GetNames();
      EXPECT_TRUE(std::is_sorted(names.begin(), names.end())) << parameter.name;
      ReconstructionParameters parameters;
      for (const std::string & name : names)
      {
        enumeration->Set(parameters, name);
        EXPECT_EQ(ToString(GetValue(parameter, parameters)), name);
      }
      EXPECT_THROW(enumeration->Set(parameters, "none"), std::invalid_argument);
      number += static_cast<int>(names.size());
    }
  }
  EXPECT_EQ(number, 11);
}
