/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/RunProgram.h"

#include "Shared/CommandLine/FailedAllocation.h"
#include "Shared/CommandLine/ProgressBar.h"
#include "Shared/CommandLine/SignalWatch.h"

#include <itkMacro.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <regex>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace tissue
{
namespace
{
/** Filters of ITK pass it on as an exception of their own. */
bool
IsLackOfMemory(const std::exception & error, const std::string & text)
{
  return dynamic_cast<const std::bad_alloc *>(&error) || dynamic_cast<const itk::MemoryAllocationError *>(&error) ||
         text.find("std::bad_alloc") != std::string::npos;
}
} // namespace

std::string
ToMessage(const std::exception & error)
{
  const auto *      itkError = dynamic_cast<const itk::ExceptionObject *>(&error);
  const std::string text = (itkError ? itkError->GetDescription() : error.what());
  if (IsLackOfMemory(error, text))
  {
    return DescribeLackOfMemory(LastFailedAllocation(), ProgressBar::GetLastPhase());
  }
  // "ITK ERROR: Class(0x55d1): ", and the name of the function that our core, or a library, begins with.
  static const std::regex prefix(R"(^((ITK |itk::)ERROR: )?(\w+ ?\((0x)?[0-9a-fA-F]+\): )?([A-Z]\w+: )?)");
  static const std::regex spaces(R"(\s+)");
  // Regular expressions recurse: a file may have long words.
  constexpr std::size_t longest = 4096;
  std::string message = std::regex_replace(std::regex_replace(text.substr(0, longest), prefix, ""), spaces, " ");
  message.erase(message.find_last_not_of(' ') + 1);
  return message;
}

namespace
{
/** Gives large arrays back to the system as soon as they are freed. The C library of GNU comes to keep those of up to
 * 32 MB for later use, which is a quarter of the memory of a large tissue. For smaller ones that is not worth the time.
 */
void
ReturnLargeArrays()
{
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 4 * megabyte);
  mallopt(M_TRIM_THRESHOLD, 64 * megabyte);
#endif
}

/** Ends the program without the ends of libraries: HDF5 tries in vain to close what it could not read, and says so. */
[[noreturn]] void
EndAfterError(const std::string & name, const std::string & message, int exitCode)
{
  std::cout << std::flush;
  std::fflush(stdout);
  std::cerr << name << ": " << message << std::endl;
  std::quick_exit(exitCode);
}
} // namespace

int
RunProgram(const std::string & name, const std::function<void()> & work)
{
  WatchSignals();
  ReturnLargeArrays();
  try
  {
    work();
  }
  catch (const StrictError & error)
  {
    constexpr int exitCode = 2;
    EndAfterError(name, error.what(), exitCode);
  }
  catch (const std::exception & error)
  {
    EndAfterError(name, ToMessage(error), EXIT_FAILURE);
  }
  catch (...)
  {
    EndAfterError(name, "an unknown error", EXIT_FAILURE);
  }
  return EXIT_SUCCESS;
}
} // namespace tissue
