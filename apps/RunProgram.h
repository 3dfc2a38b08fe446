/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RunProgram_h
#define RunProgram_h

#include <exception>
#include <functional>
#include <string>

namespace tissue
{
/** An error for a person, in one line: without the class names and addresses that ITK puts before it. */
std::string
ToMessage(const std::exception & error);

/** Does the work of a program. An error is said in one line on standard error, after the program's name. Returns the
 * exit code: 0, or 1 after an error. */
int
RunProgram(const std::string & name, const std::function<void()> & work);
} // namespace tissue

#endif
