/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/DelimitedText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

using namespace tissue;

namespace
{
using Fields = std::vector<std::string>;

DelimitedText
Read(const std::string & text)
{
  std::istringstream stream(text);
  return ReadDelimitedText(stream);
}

/** The message of the error, or nothing. */
std::string
Refusal(const std::string & text)
{
  try
  {
    Read(text);
    return "";
  }
  catch (const std::runtime_error & error)
  {
    return error.what();
  }
}
} // namespace

TEST(DelimitedText, LinesEndInAnyWayAndEmptyOnesAreLeftOut)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    const auto text = Read("\xEF\xBB\xBF"
                           "a,b" +
                           end + end + " \t" + end + ",," + end + "# c = d" + end + " 1 ,," + end + "2");
    ASSERT_EQ(text.records.size(), 3u);
    EXPECT_EQ(text.records[0].fields, (Fields{ "a", "b" }));
    EXPECT_EQ(text.records[0].line, 1u);
    EXPECT_EQ(text.records[1].fields, (Fields{ "1", "", "" }));
    EXPECT_EQ(text.records[1].line, 6u);
    EXPECT_EQ(text.records[2].fields, (Fields{ "2" }));
    ASSERT_EQ(text.comments.size(), 1u);
    EXPECT_TRUE(IsComment(" ## c"));
    EXPECT_TRUE(IsComment("% c"));
    EXPECT_FALSE(IsComment("c #"));
    EXPECT_EQ(text.comments[0].text, "c = d");
    EXPECT_EQ(text.comments[0].line, 5u);
  }
  EXPECT_TRUE(Read("").records.empty());
}

TEST(DelimitedText, QuotesHoldSeparatorsQuotesAndLineEnds)
{
  const auto text = Read("\"a, \"\"b\"\"\" , 5\" nail,\"\"\n\"two\nlines\",x\n#,\ny\n");
  ASSERT_EQ(text.records.size(), 3u);
  EXPECT_EQ(text.records[0].fields, (Fields{ "a, \"b\"", "5\" nail", "" }));
  EXPECT_EQ(text.records[1].fields, (Fields{ "two\nlines", "x" }));
  EXPECT_EQ(text.records[2].line, 5u);
  EXPECT_EQ(Refusal("a\nb,\"c\n\n"), "line 2: a quote is not closed");
  EXPECT_EQ(Refusal("a\nb,\"c\"d\n"), "line 2: there is text after the quoted 'c'");
}

TEST(DelimitedText, SeparatorIsFoundSaidOrGiven)
{
  EXPECT_EQ(Read(std::string("\xFF\xFEx\0,\0y\0", 8)).records[0].fields, (Fields{ "x", "y" }));
  for (const std::string said : { "sep=;", "SEP=;", "\"sep=;\"" })
  {
    const auto text = Read(said + "\na,b;c\n");
    ASSERT_EQ(text.records.size(), 1u);
    EXPECT_EQ(text.records[0].fields, (Fields{ "a,b", "c" }));
    EXPECT_EQ(text.records[0].line, 2u);
  }
  std::istringstream stream("a;b;c,d\n");
  EXPECT_EQ(ReadDelimitedText(stream, ',').records[0].fields, (Fields{ "a;b;c", "d" }));
  EXPECT_EQ(Read("x;y;z\n1,5;2;3\n").records[1].fields, (Fields{ "1,5", "2", "3" }));
  EXPECT_EQ(Read("x\ty\tz\n\t 2\t3 \n").records[1].fields, (Fields{ "", "2", "3" }));
  EXPECT_EQ(Read("\"a;b;c;d\",y,z\n1,2;,3\n").records[1].fields, (Fields{ "1", "2;", "3" }));
  EXPECT_EQ(SplitFields("id, x,y"), (Fields{ "id", "x", "y" }));
  EXPECT_EQ(SplitFields(""), Fields());
  EXPECT_EQ(Read("  x  y\t z \n1 \"a b\"  3\n").records[0].fields, (Fields{ "x", "y", "z" }));
  EXPECT_EQ(Read("  x  y\t z \n1 \"a b\"  3\n").records[1].fields, (Fields{ "1", "a b", "3" }));
}

TEST(DelimitedText, NumbersAreWholeTexts)
{
  EXPECT_EQ(ToNumber("1.5"), 1.5);
  EXPECT_EQ(ToNumber("+2e-3"), 2e-3);
  EXPECT_EQ(ToNumber("-.5"), -0.5);
  EXPECT_EQ(ToNumber("1e999"), INFINITY);
  EXPECT_EQ(ToNumber("-inf"), -INFINITY);
  EXPECT_TRUE(std::isnan(*ToNumber("nan")));
  for (const char * text : { "", "+", "+-1", "1,5", "1 2", "0x10", "1.5 um" })
  {
    EXPECT_FALSE(ToNumber(text)) << text;
  }
}
