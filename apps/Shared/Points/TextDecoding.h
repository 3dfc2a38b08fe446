/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TextDecoding_h
#define TextDecoding_h

#include <string>

namespace tissue
{
/** \brief Turns the bytes of a text file into UTF-8, without a byte order mark.
 *
 * Read are UTF-8, UTF-16 of either byte order (by its mark, or by the zero bytes that text of mostly Latin letters has
 * there), and what is no UTF-8 as Latin-1, which shares its letters with what Windows and the Macintosh write where it
 * matters here: the sign of micro.
 * \throws std::runtime_error: other zero bytes (no text), half a character of UTF-16. */
std::string
DecodeText(const std::string & bytes);
} // namespace tissue

#endif
