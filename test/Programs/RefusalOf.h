/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef RefusalOf_h
#define RefusalOf_h

#include <stdexcept>
#include <string>

/** The message of the error that `work` throws, or nothing. */
template <typename TWork>
std::string
RefusalOf(const TWork & work)
{
  try
  {
    work();
    return "";
  }
  catch (const std::runtime_error & error)
  {
    return error.what();
  }
}

#endif
