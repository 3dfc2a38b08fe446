/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef FieldSeparator_h
#define FieldSeparator_h

#include <string>

namespace tissue
{
/** \brief What separates the fields of a text: a tab, a semicolon, a comma, a bar or, as ' ', runs of blanks.
 *
 * The one by which the most lines have one number of fields, of three and more if there is any; where several do, the
 * first of this list, so that commas may be decimal signs between semicolons, and blanks be within fields. Separators
 * in quotes, empty lines and comments do not count. A comma where there is none. */
char
FindSeparator(const std::string & text);
} // namespace tissue

#endif
