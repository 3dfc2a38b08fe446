/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/HeaderLines.h"

#include "Shared/Images/VoxelFiles.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tissue
{
HeaderLines::HeaderLines(const std::string & path)
  : m_File(path, std::ios::binary)
{}

bool
HeaderLines::Next(std::string & line)
{
  constexpr std::size_t   longestLine = 1000000;
  constexpr std::uint64_t longestHeader = 16000000;
  line.clear();
  const std::uint64_t start = m_Offset;
  for (int c = m_File.get(); c != std::ifstream::traits_type::eof(); c = m_File.get())
  {
    ++m_Offset;
    if (c == '\n')
    {
      break;
    }
    line += static_cast<char>(c);
    if (line.size() > longestLine || m_Offset > longestHeader)
    {
      throw std::runtime_error("the header does not end: it has a line of more than " + std::to_string(longestLine) +
                               " characters, or more than " + std::to_string(longestHeader) + " in all");
    }
  }
  line = Trim(line);
  return m_Offset > start;
}

std::string
Trim(const std::string & text)
{
  constexpr char    blanks[] = " \t\r\f\v";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string>
SplitWords(const std::string & text)
{
  std::istringstream       stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
  {
    words.push_back(word);
  }
  return words;
}

std::vector<double>
ReadNumbers(const std::string & field, const std::string & text, std::size_t least)
{
  std::vector<double> numbers;
  for (const std::string & word : SplitWords(text))
  {
    std::size_t end = 0;
    double      number = NAN;
    if (word.find_first_not_of("0123456789+-.eE") == std::string::npos)
    {
      try
      {
        number = std::stod(word, &end);
      }
      catch (const std::logic_error &)
      {
        end = 0;
      }
    }
    if (end != word.size())
    {
      throw std::runtime_error("the header has " + field + " = " + Shorten(text) + ": '" + Shorten(word) +
                               "' is no number");
    }
    numbers.push_back(number);
  }
  if (numbers.size() < least)
  {
    throw std::runtime_error("the header has " + field + " = " + Shorten(text) + ", which must have " +
                             std::to_string(least) + " numbers");
  }
  return numbers;
}

std::vector<std::int64_t>
ReadWholeNumbers(const std::string & field, const std::string & text, std::size_t least, std::int64_t lowest,
                 std::int64_t highest)
{
  std::vector<std::int64_t> numbers;
  for (const double number : ReadNumbers(field, text, least))
  {
    if (!(number >= static_cast<double>(lowest) && number <= static_cast<double>(highest) &&
          number == std::floor(number)))
    {
      throw std::runtime_error("the header has " + field + " = " + Shorten(text) + ", must be in " +
                               std::to_string(lowest) + " .. " + std::to_string(highest));
    }
    numbers.push_back(static_cast<std::int64_t>(number));
  }
  return numbers;
}
} // namespace tissue
