/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/FailedAllocation.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>
#include <sstream>

// Sanitizers bring an operator of their own.
#if defined(__has_feature)
#  if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#    define TISSUE_TESSELLATION_IS_SANITIZED
#  endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#  define TISSUE_TESSELLATION_IS_SANITIZED
#endif

namespace
{
std::atomic<std::size_t> lastFailed{ 0 };
}

#ifndef TISSUE_TESSELLATION_IS_SANITIZED
void *
operator new(std::size_t size)
{
  if (void * const memory = std::malloc(size > 0 ? size : 1))
  {
    return memory;
  }
  lastFailed = size;
  throw std::bad_alloc();
}

void
operator delete(void * memory) noexcept
{
  std::free(memory);
}

void
operator delete(void * memory, std::size_t) noexcept
{
  std::free(memory);
}
#endif

namespace tissue
{
std::size_t
LastFailedAllocation()
{
  return lastFailed;
}

std::string
DescribeLackOfMemory(std::size_t bytes, const std::string & phase)
{
  constexpr double      megabyte = 1e6;
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max() / 4;
  std::ostringstream    text;
  text << "out of memory";
  if (bytes > 0 && bytes < most)
  {
    text << ": " << static_cast<double>(bytes) / megabyte << " MB more were wanted";
  }
  if (!phase.empty())
  {
    text << (bytes > 0 && bytes < most ? " for " : ": ") << "'" << phase << "'";
  }
  return text.str();
}
} // namespace tissue
