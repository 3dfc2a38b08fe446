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
#include <stdexcept>
#include <string>

namespace tissue
{
/** An error for a person, in one line: without the class names and addresses that ITK puts before it. */
std::string
ToMessage(const std::exception & error);

/** An error that names the file it is about. */
class FileError : public std::runtime_error
{
public:
  FileError(const std::string & path, const std::exception & error)
    : std::runtime_error(path + ": " + ToMessage(error))
  {}
};

/** A result that is written, but not as it should be. */
class StrictError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** What `work` returns; its errors become those of the file, unless they name one already. */
template <typename TWork>
auto
WithFileName(const std::string & path, const TWork & work) -> decltype(work())
{
  try
  {
    return work();
  }
  catch (const FileError &)
  {
    throw;
  }
  catch (const std::exception & error)
  {
    throw FileError(path, error);
  }
}

/** Does the work of a program. An error is said in one line on standard error, after the program's name. Returns
 * the exit code, 0, or ends the program by it: 1 after an error, 2 after a StrictError. Watches signals, see
 * WatchSignals(). */
int
RunProgram(const std::string & name, const std::function<void()> & work);
} // namespace tissue

#endif
