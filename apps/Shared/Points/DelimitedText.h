/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef DelimitedText_h
#define DelimitedText_h

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** Text in lines of fields, as comma-separated values. */
struct DelimitedText
{
  struct Record
  {
    std::vector<std::string> fields;
    /** Where it begins, from 1 on. */
    std::size_t line;
  };
  struct Comment
  {
    std::string text;
    std::size_t line;
  };
  /** Those with any content. */
  std::vector<Record> records;
  /** Lines that begin with # or %, without those and the blanks around. */
  std::vector<Comment> comments;
};

/** \brief Splits text into fields, by the rules of RFC 4180.
 *
 * A field in double quotes may hold separators, line ends, and quotes that are doubled; of others the blanks around are
 * left out. Lines end in LF, CR LF or CR; the encoding is found by DecodeText().
 *
 * VTK's reader of such text knows nothing of lines, which messages must name.
 * \param separator of the fields, where ' ' is any number of blanks; by default the one that a first line "sep=;" says,
 * as for Excel, or else that of FindSeparator().
 * \throws std::runtime_error that names the line: a quote that is not closed, or text after a closed one; and as of
 * DecodeText().
 */
DelimitedText
ReadDelimitedText(std::istream & stream, char separator = '\0');

/** The fields of one line, which is no comment. */
std::vector<std::string>
SplitFields(const std::string & line);

bool
IsComment(const std::string & line);

/** Without the blanks at both ends. */
std::string
TrimBlanks(const std::string & text);

/** A whole text that is a number, also "nan" and "inf", in any locale with a decimal point; infinite where it exceeds a
 * double. */
std::optional<double>
ToNumber(const std::string & text);
} // namespace tissue

#endif
