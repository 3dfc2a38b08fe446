/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/DelimitedText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace tissue
{
namespace
{
bool
IsLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

bool
IsBlank(char c)
{
  return c == ' ' || c == '\t';
}

/** Goes through the text once. */
class Parser
{
public:
  explicit Parser(std::string text)
    : m_Text(std::move(text))
  {
    if (m_Text.find('\0') != std::string::npos)
    {
      throw std::runtime_error("the text has zero bytes, must be in UTF-8: UTF-16, or no text, is not read");
    }
    constexpr const char * mark = "\xEF\xBB\xBF";
    m_Position = m_Text.compare(0, 3, mark) == 0 ? 3 : 0;
  }

  DelimitedText
  Parse()
  {
    DelimitedText result;
    for (; m_Position < m_Text.size(); this->SkipLineEnd())
    {
      const std::size_t line = m_Line;
      this->SkipBlanks();
      if (this->Peek() == '#')
      {
        ++m_Position;
        result.comments.push_back({ TrimBlanks(this->ReadRest()), line });
        continue;
      }
      DelimitedText::Record record{ this->ReadFields(), line };
      const auto            isEmpty = [](const std::string & field) { return field.empty(); };
      if (!std::all_of(record.fields.begin(), record.fields.end(), isEmpty))
      {
        result.records.push_back(std::move(record));
      }
    }
    return result;
  }

private:
  /** The character, or a line end where there are no more. */
  char
  Peek() const
  {
    return m_Position < m_Text.size() ? m_Text[m_Position] : '\n';
  }

  void
  SkipLineEnd()
  {
    m_Position += m_Text.compare(m_Position, 2, "\r\n") == 0 ? 2 : 1;
    ++m_Line;
  }

  void
  SkipBlanks()
  {
    while (IsBlank(this->Peek()) && this->Peek() != m_Separator)
    {
      ++m_Position;
    }
  }

  std::string
  ReadRest()
  {
    const std::size_t begin = m_Position;
    m_Position = std::min(m_Text.find_first_of("\r\n", begin), m_Text.size());
    return m_Text.substr(begin, m_Position - begin);
  }

  std::vector<std::string>
  ReadFields()
  {
    if (m_Separator == '\0' && !IsLineEnd(this->Peek()))
    {
      m_Separator = this->FindSeparator();
    }
    std::vector<std::string> fields{ this->ReadField() };
    while (!IsLineEnd(this->Peek()))
    {
      ++m_Position;
      fields.push_back(this->ReadField());
    }
    return fields;
  }

  /** By the record that begins here. */
  char
  FindSeparator() const
  {
    const std::string          separators = ",;\t";
    std::array<std::size_t, 3> counts{};
    bool                       isQuoted = false;
    for (std::size_t i = m_Position; i < m_Text.size() && (isQuoted || !IsLineEnd(m_Text[i])); ++i)
    {
      isQuoted = isQuoted != (m_Text[i] == '"');
      const std::size_t separator = separators.find(m_Text[i]);
      if (!isQuoted && separator != std::string::npos)
      {
        ++counts[separator];
      }
    }
    return separators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
  }

  /** Up to the separator or the line's end. */
  std::string
  ReadField()
  {
    this->SkipBlanks();
    if (this->Peek() == '"')
    {
      return this->ReadQuoted();
    }
    const std::size_t begin = m_Position;
    while (!IsLineEnd(this->Peek()) && this->Peek() != m_Separator)
    {
      ++m_Position;
    }
    return TrimBlanks(m_Text.substr(begin, m_Position - begin));
  }

  std::string
  ReadQuoted()
  {
    const std::size_t firstLine = m_Line;
    std::string       field;
    for (++m_Position;; ++m_Position)
    {
      if (m_Position >= m_Text.size())
      {
        throw std::runtime_error("line " + std::to_string(firstLine) + ": a quote is not closed");
      }
      const bool isQuote = m_Text[m_Position] == '"';
      if (isQuote && m_Text.compare(m_Position, 2, "\"\"") != 0)
      {
        break;
      }
      m_Position += isQuote ? 1 : 0;
      m_Line += m_Text[m_Position] == '\n' ? 1 : 0;
      field += m_Text[m_Position];
    }
    ++m_Position;
    this->SkipBlanks();
    if (!IsLineEnd(this->Peek()) && this->Peek() != m_Separator)
    {
      throw std::runtime_error("line " + std::to_string(m_Line) + ": there is text after the quoted '" + field + "'");
    }
    return field;
  }

  std::string m_Text;
  std::size_t m_Position = 0;
  std::size_t m_Line = 1;
  /** Zero before the first record. */
  char m_Separator = '\0';
};
} // namespace

DelimitedText
ReadDelimitedText(std::istream & stream)
{
  return Parser({ std::istreambuf_iterator<char>(stream), {} }).Parse();
}

std::vector<std::string>
SplitFields(const std::string & line)
{
  std::istringstream  stream(line);
  const DelimitedText text = ReadDelimitedText(stream);
  return text.records.empty() ? std::vector<std::string>() : text.records.front().fields;
}

std::string
TrimBlanks(const std::string & text)
{
  const auto begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::optional<double>
ToNumber(const std::string & text)
{
  // Which std::from_chars() takes for no number.
  const bool         hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char * const end = text.data() + text.size();
  double             value = 0.0;
  const auto         result = std::from_chars(text.data() + (hasPlus ? 1 : 0), end, value);
  if (result.ec == std::errc::invalid_argument || result.ptr != end)
  {
    return std::nullopt;
  }
  return result.ec == std::errc() ? value : std::numeric_limits<double>::infinity();
}
} // namespace tissue
