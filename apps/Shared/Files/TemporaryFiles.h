/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TemporaryFiles_h
#define TemporaryFiles_h

#include <mutex>
#include <set>
#include <string>

namespace tissue
{
/** \brief The temporary files and folders that the program has, so that none is left when a signal ends it.
 *
 * There is one such list, from the first use to the end of the program. Whoever makes or renames such a file holds the
 * list meanwhile. */
class TemporaryFiles
{
public:
  static TemporaryFiles &
  GetInstance();

  /** Nobody else makes, renames or removes temporary files while this lasts; a thread may hold the list twice. */
  std::unique_lock<std::recursive_mutex>
  Hold();

  /** A file or folder that is about to be made. */
  void
  Add(const std::string & path);

  /** It is temporary no more, or not there. */
  void
  Forget(const std::string & path);

  /** Removes a file or folder, with all that is in it, and forgets it. */
  void
  Remove(const std::string & path);

  /** Removes all that are left. */
  void
  RemoveAll();

private:
  TemporaryFiles() = default;

  std::recursive_mutex  m_Mutex;
  std::set<std::string> m_Paths;
};
} // namespace tissue

#endif
