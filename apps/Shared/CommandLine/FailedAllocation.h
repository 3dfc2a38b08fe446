/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef FailedAllocation_h
#define FailedAllocation_h

#include <cstddef>
#include <string>

namespace tissue
{
/** \brief Bytes that `new` wanted in vain when it failed the last time; 0 where it never did, or where that is not
 * known.
 *
 * The programs have an operator `new` that notes it. */
std::size_t
LastFailedAllocation();

/** The message for a lack of memory: how much was wanted, and in which phase of the program.
 * \param phase empty where it is not known. */
std::string
DescribeLackOfMemory(std::size_t bytes, const std::string & phase);
} // namespace tissue

#endif
