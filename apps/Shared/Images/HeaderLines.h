/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef HeaderLines_h
#define HeaderLines_h

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace tissue
{
/** \brief The lines of a header of text, at the beginning of a file that may hold anything behind it.
 *
 * Lines have at most a million characters, headers 16 million: the rest is not read, which throws std::runtime_error.
 */
class HeaderLines
{
public:
  explicit HeaderLines(const std::string & path);

  /** Reads a line without its end and without blanks around it. Returns whether there was one. */
  bool
  Next(std::string & line);

  /** Bytes of the file before the next line. */
  std::uint64_t
  GetOffset() const
  {
    return m_Offset;
  }

private:
  std::ifstream m_File;
  std::uint64_t m_Offset = 0;
};

/** Without blanks around it. */
std::string
Trim(const std::string & text);

/** What is between blanks. */
std::vector<std::string>
SplitWords(const std::string & text);

/** \brief The numbers in a text, with blanks between them.
 *
 * Throws std::runtime_error, which names the field, where there are fewer than `least`, or one is no decimal number. */
std::vector<double>
ReadNumbers(const std::string & field, const std::string & text, std::size_t least);

/** As ReadNumbers(), of whole numbers from `lowest` to `highest`. */
std::vector<std::int64_t>
ReadWholeNumbers(const std::string & field, const std::string & text, std::size_t least, std::int64_t lowest,
                 std::int64_t highest);
} // namespace tissue

#endif
