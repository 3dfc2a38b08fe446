/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/TextDecoding.h"

#include "RefusalOf.h"

#include <gtest/gtest.h>

using namespace tissue;

namespace
{
const std::string text = "x (\xC2\xB5m)\n\xF0\x9D\x84\x9E and more text";

/** The same text in UTF-16. */
std::string
InUTF16(bool isBigEndian, bool hasMark)
{
  std::string result;
  const auto  append = [&](unsigned int code) {
    const char high = static_cast<char>(code >> 8);
    const char low = static_cast<char>(code & 0xFF);
    result += isBigEndian ? std::string{ high, low } : std::string{ low, high };
  };
  if (hasMark)
  {
    append(0xFEFF);
  }
  for (const unsigned int code : { 0x78, 0x20, 0x28, 0xB5, 0x6D, 0x29, 0x0A, 0xD834, 0xDD1E })
  {
    append(code);
  }
  for (const char c : std::string(" and more text"))
  {
    append(static_cast<unsigned char>(c));
  }
  return result;
}

std::string
Refusal(const std::string & bytes)
{
  return RefusalOf([&] { DecodeText(bytes); });
}
} // namespace

TEST(TextDecoding, EveryEncodingBecomesUTF8WithoutAMark)
{
  EXPECT_EQ(DecodeText(text), text);
  EXPECT_EQ(DecodeText("\xEF\xBB\xBF" + text), text);
  for (const bool isBigEndian : { false, true })
  {
    EXPECT_EQ(DecodeText(InUTF16(isBigEndian, true)), text);
    EXPECT_EQ(DecodeText(InUTF16(isBigEndian, false)), text);
  }
  EXPECT_EQ(DecodeText(""), "");
}

TEST(TextDecoding, WhatIsNoUTF8IsLatin1)
{
  EXPECT_EQ(DecodeText("x (\xB5m)"), "x (\xC2\xB5m)");
  EXPECT_EQ(DecodeText("\xE9"), "\xC3\xA9");
  // Cut off, in more bytes than needed, half a pair of UTF-16, beyond Unicode.
  for (const std::string bytes : { "\xC2", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80" })
  {
    EXPECT_EQ(DecodeText(bytes).size(), 2 * bytes.size());
  }
}

TEST(TextDecoding, WhatIsNoTextIsRefused)
{
  EXPECT_NE(Refusal(std::string("a\0b\0\0c", 6)).find("zero bytes"), std::string::npos);
  EXPECT_NE(Refusal(std::string("\xFF\xFEx\0,", 5)).find("ends within a character"), std::string::npos);
  EXPECT_NE(Refusal(std::string("\xFF\xFEx\0\0\xDC", 6)).find("half a character at byte 4"), std::string::npos);
  EXPECT_NE(Refusal(std::string("\xFF\xFE\0\xD8", 4)).find("half a character at byte 2"), std::string::npos);
}
