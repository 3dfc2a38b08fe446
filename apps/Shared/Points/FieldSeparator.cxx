/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/FieldSeparator.h"

#include "Shared/Points/DelimitedText.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace tissue
{
namespace
{
/** The separators of a line outside of quotes, which begin where fields do. */
std::size_t
CountSeparators(const std::string & line, char separator)
{
  std::size_t count = 0;
  bool        isQuoted = false;
  bool        isAtBegin = true;
  bool        wasBlank = false;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    const char c = line[i];
    if (isQuoted)
    {
      // A doubled quote is one within.
      const bool isDoubled = c == '"' && line.compare(i, 2, "\"\"") == 0;
      i += isDoubled ? 1 : 0;
      isQuoted = c != '"' || isDoubled;
      continue;
    }
    const bool isBlank = c == ' ' || c == '\t';
    const bool isSeparator = separator == ' ' ? isBlank && !wasBlank : c == separator;
    count += isSeparator ? 1 : 0;
    isQuoted = c == '"' && isAtBegin;
    isAtBegin = isSeparator || (isAtBegin && isBlank);
    wasBlank = isBlank;
  }
  return count;
}

/** The most lines of one number of fields: first of three fields and more, then of two. */
std::pair<std::size_t, std::size_t>
CountEqualLines(const std::string & text, char separator)
{
  std::map<std::size_t, std::size_t> lines;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::string       line = text.substr(begin, end - begin);
    if (separator == ' ')
    {
      line = TrimBlanks(line);
    }
    if (!IsComment(line))
    {
      ++lines[CountSeparators(line, separator)];
    }
    begin = end + 1;
  }
  std::pair<std::size_t, std::size_t> most{ 0, lines.count(1) > 0 ? lines.at(1) : 0 };
  for (const auto & [separators, count] : lines)
  {
    most.first = separators >= 2 ? std::max(most.first, count) : most.first;
  }
  return most;
}
} // namespace

char
FindSeparator(const std::string & text)
{
  char                                best = ',';
  std::pair<std::size_t, std::size_t> most{ 0, 0 };
  for (const char separator : { '\t', ';', ',', '|', ' ' })
  {
    const auto lines = CountEqualLines(text, separator);
    if (lines > most)
    {
      most = lines;
      best = separator;
    }
  }
  return best;
}
} // namespace tissue
