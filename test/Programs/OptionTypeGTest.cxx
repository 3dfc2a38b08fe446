/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/OptionType.h"

#include "Shared/CommandLine/OptionChecks.h"

#include <gtest/gtest.h>

using namespace tissue;

TEST(OptionType, TellsNumbersWithTheirRange)
{
  CLI::App         app;
  double           real = 0.0;
  unsigned int     number = 0;
  const OptionType ofReal(*app.add_option("--real", real)->check(InRange(-2.5, 1e12)));
  EXPECT_TRUE(ofReal.isReal && !ofReal.isInteger);
  EXPECT_EQ(ofReal.least, -2.5);
  EXPECT_EQ(ofReal.most, 1e12);
  EXPECT_TRUE(ofReal.Contains(-2.5) && !ofReal.Contains(-2.6));
  const OptionType ofInteger(*app.add_option("--integer", number));
  EXPECT_TRUE(ofInteger.isInteger && !ofInteger.isReal);
  EXPECT_FALSE(ofInteger.least);
  EXPECT_TRUE(ofInteger.Contains(-1e300));
  EXPECT_TRUE(OptionType(*app.add_option("--named", number)->type_name("NUMBER")->check(InRange(1, 9))).isInteger);
}

TEST(OptionType, TellsChoicesAndFiles)
{
  CLI::App         app;
  std::string      text;
  const auto       among = CLI::IsMember({ "auto", "on" });
  const OptionType choice(*app.add_option("--choice", text)->check(among)->type_name("{auto,on}"));
  EXPECT_EQ(choice.choices, (std::vector<std::string>{ "auto", "on" }));
  EXPECT_TRUE(choice.extension.empty());
  const OptionType file(*app.add_option("--file", text)->type_name("FILE")->check(EndsIn(".vtp")));
  EXPECT_EQ(file.type, "FILE");
  EXPECT_EQ(file.extension, ".vtp");
  EXPECT_TRUE(OptionType(*app.add_option("--input", text)->type_name("FILE")).extension.empty());
}

TEST(OptionType, TakesWholeTextsForNumbersAlone)
{
  EXPECT_EQ(FindNumber("-2.5e3"), -2500.0);
  for (const char * text : { "", "3 ", "3,5", "0.5.mha", "three" })
  {
    EXPECT_FALSE(FindNumber(text)) << text;
  }
}
