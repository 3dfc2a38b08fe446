/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/TemporaryFiles.h"

#include <filesystem>
#include <system_error>

namespace tissue
{
TemporaryFiles &
TemporaryFiles::GetInstance()
{
  // A signal may come while the program's objects are destroyed already: this one never is.
  static auto * const instance = new TemporaryFiles;
  return *instance;
}

std::unique_lock<std::recursive_mutex>
TemporaryFiles::Hold()
{
  return std::unique_lock<std::recursive_mutex>(m_Mutex);
}

void
TemporaryFiles::Add(const std::string & path)
{
  const auto lock = this->Hold();
  m_Paths.insert(path);
}

void
TemporaryFiles::Forget(const std::string & path)
{
  const auto lock = this->Hold();
  m_Paths.erase(path);
}

void
TemporaryFiles::Remove(const std::string & path)
{
  const auto      lock = this->Hold();
  std::error_code ignored;
  std::filesystem::remove_all(path, ignored);
  m_Paths.erase(path);
}

void
TemporaryFiles::RemoveAll()
{
  const auto lock = this->Hold();
  while (!m_Paths.empty())
  {
    this->Remove(std::string(*m_Paths.begin()));
  }
}
} // namespace tissue
