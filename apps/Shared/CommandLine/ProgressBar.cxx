/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/ProgressBar.h"

#include <unistd.h>

#include <cstdio>

namespace tissue
{
ProgressBar::ProgressBar(bool isQuiet)
  : m_IsActive(!isQuiet && isatty(fileno(stderr)) != 0)
{}

ProgressBar::~ProgressBar()
{
  this->End();
}

void
ProgressBar::Begin(const std::string & phase)
{
  m_Phase = phase;
  m_Percent = -1;
  this->Show(0.0);
}

void
ProgressBar::Observe(itk::ProcessObject * filter)
{
  if (m_IsActive)
  {
    filter->AddObserver(itk::ProgressEvent(),
                        [this, filter](const itk::EventObject &) { this->Show(filter->GetProgress()); });
  }
}

void
ProgressBar::Show(double fraction)
{
  constexpr int width = 40;
  const int     percent = static_cast<int>(100.0 * fraction + 0.5);
  if (!m_IsActive || percent == m_Percent)
  {
    return;
  }
  m_Percent = percent;
  const std::string done(static_cast<std::size_t>(width * percent / 100), '#');
  std::fprintf(stderr, "\r\033[K%-22s [%-*s] %3d %%", m_Phase.c_str(), width, done.c_str(), percent);
  std::fflush(stderr);
}

void
ProgressBar::End()
{
  if (m_IsActive)
  {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
  }
}
} // namespace tissue
