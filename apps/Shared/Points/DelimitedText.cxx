/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Points/DelimitedText.h"

#include "Shared/Points/FieldSeparator.h"
#include "Shared/Points/TextDecoding.h"

#include <algorithm>
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
IsCommentMark(char c)
{
  return c == '#' || c == '%';
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
  /** \param separator zero: it is found. */
  Parser(std::string text, char separator)
    : m_Text(std::move(text))
    , m_Separator(separator != '\0' ? separator : this->ReadSeparator())
  {}

  DelimitedText
  Parse()
  {
    DelimitedText result;
    for (; m_Position < m_Text.size(); this->SkipLineEnd())
    {
      const std::size_t line = m_Line;
      this->SkipIndent();
      if (IsCommentMark(this->Peek()))
      {
        m_Position = m_Text.find_first_not_of(this->Peek(), m_Position);
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

  /** What the first line says of it, as for Excel: "sep=;"; it is then read. */
  char
  ReadSeparator()
  {
    const std::string line = this->ReadRest();
    const std::string text = line.size() > 1 && line.front() == '"' ? line.substr(1, line.size() - 2) : line;
    if (text.size() == 5 && (text.compare(0, 4, "sep=") == 0 || text.compare(0, 4, "SEP=") == 0))
    {
      return text.back();
    }
    m_Position = 0;
    return FindSeparator(m_Text);
  }

  bool
  IsAtSeparator() const
  {
    return m_Separator == ' ' ? IsBlank(this->Peek()) : this->Peek() == m_Separator;
  }

  /** Before a field or behind it. */
  void
  SkipBlanks()
  {
    while (IsBlank(this->Peek()) && !this->IsAtSeparator())
    {
      ++m_Position;
    }
  }

  /** Before a line's first field. */
  void
  SkipIndent()
  {
    while (IsBlank(this->Peek()) && this->Peek() != (m_Separator == ' ' ? '\0' : m_Separator))
    {
      ++m_Position;
    }
  }

  /** Of blanks all are one; those at the end of a line are none. */
  void
  SkipSeparator()
  {
    m_Position += m_Separator == ' ' ? 0 : 1;
    if (m_Separator == ' ')
    {
      this->SkipIndent();
    }
  }

  std::string
  ReadRest()
  {
    const std::size_t begin = std::min(m_Position, m_Text.size());
    m_Position = std::min(m_Text.find_first_of("\r\n", begin), m_Text.size());
    return m_Text.substr(begin, m_Position - begin);
  }

  std::vector<std::string>
  ReadFields()
  {
    std::vector<std::string> fields{ this->ReadField() };
    while (!IsLineEnd(this->Peek()))
    {
      this->SkipSeparator();
      if (m_Separator != ' ' || !IsLineEnd(this->Peek()))
      {
        fields.push_back(this->ReadField());
      }
    }
    return fields;
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
    while (!IsLineEnd(this->Peek()) && !this->IsAtSeparator())
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
    if (!IsLineEnd(this->Peek()) && !this->IsAtSeparator())
    {
      throw std::runtime_error("line " + std::to_string(m_Line) + ": there is text after the quoted '" + field + "'");
    }
    return field;
  }

  std::string m_Text;
  std::size_t m_Position = 0;
  std::size_t m_Line = 1;
  char        m_Separator;
};
} // namespace

DelimitedText
ReadDelimitedText(std::istream & stream, char separator)
{
  return Parser(DecodeText({ std::istreambuf_iterator<char>(stream), {} }), separator).Parse();
}

std::vector<std::string>
SplitFields(const std::string & line)
{
  std::istringstream  stream(line);
  const DelimitedText text = ReadDelimitedText(stream);
  return text.records.empty() ? std::vector<std::string>() : text.records.front().fields;
}

bool
IsComment(const std::string & line)
{
  const std::string trimmed = TrimBlanks(line);
  return !trimmed.empty() && IsCommentMark(trimmed.front());
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
