/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Images/StandardErrorCapture.h"

#include <unistd.h>

namespace tissue
{
StandardErrorCapture::StandardErrorCapture()
  : m_File(std::tmpfile())
{
  if (m_File)
  {
    std::fflush(stderr);
    m_StandardError = dup(STDERR_FILENO);
    dup2(fileno(m_File), STDERR_FILENO);
  }
}

StandardErrorCapture::~StandardErrorCapture()
{
  this->Release();
}

std::string
StandardErrorCapture::Release()
{
  std::string text;
  if (!m_File)
  {
    return text;
  }
  std::fflush(stderr);
  dup2(m_StandardError, STDERR_FILENO);
  close(m_StandardError);
  std::rewind(m_File);
  char buffer[1024];
  for (std::size_t size; (size = std::fread(buffer, 1, sizeof(buffer), m_File)) > 0;)
  {
    text.append(buffer, size);
  }
  std::fclose(m_File);
  m_File = nullptr;
  return text;
}
} // namespace tissue
