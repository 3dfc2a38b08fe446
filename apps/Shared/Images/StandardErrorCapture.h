/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef StandardErrorCapture_h
#define StandardErrorCapture_h

#include <cstdio>
#include <string>

namespace tissue
{
/** \brief Collects what the process writes on standard error, as long as it lives.
 *
 * For libraries that tell of a broken file there and nowhere else. Where no temporary file can be made nothing is
 * collected, and all is written as ever. */
class StandardErrorCapture
{
public:
  StandardErrorCapture();
  ~StandardErrorCapture();
  StandardErrorCapture(const StandardErrorCapture &) = delete;
  StandardErrorCapture &
  operator=(const StandardErrorCapture &) = delete;

  /** Ends the collection and returns what there was. */
  std::string
  Release();

private:
  std::FILE * m_File;
  int         m_StandardError = -1;
};
} // namespace tissue

#endif
