/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/ProgressBar.h"

#include <unistd.h>

#include <cstdio>
#include <exception>

namespace tissue
{
namespace
{
std::mutex  lastPhaseMutex;
std::string lastPhase;

void
SetLastPhase(const std::string & phase)
{
  const std::lock_guard<std::mutex> lock(lastPhaseMutex);
  lastPhase = phase;
}
} // namespace

ProgressStyle
ChooseProgressStyle(const std::string & name)
{
  const bool isTerminal = isatty(fileno(stderr)) != 0;
  return name == "lines"                                   ? ProgressStyle::Lines
         : name == "slicer"                                ? ProgressStyle::Slicer
         : name == "bar" || (name == "auto" && isTerminal) ? ProgressStyle::Bar
                                                           : ProgressStyle::None;
}

ProgressBar::ProgressBar(ProgressStyle style)
  : m_Style(style)
{
  if (m_Style != ProgressStyle::None)
  {
    m_Ticker = std::thread([this] { this->Tick(); });
  }
}

ProgressBar::~ProgressBar()
{
  this->End();
  if (m_Ticker.joinable())
  {
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      m_IsStopping = true;
    }
    m_Stopping.notify_one();
    m_Ticker.join();
  }
}

void
ProgressBar::Begin(const std::string & phase)
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  m_Percent = 0;
  this->ChangePhase(phase);
  this->Show();
}

void
ProgressBar::Observe(itk::ProcessObject * filter, std::function<std::string()> phaseOfFilter)
{
  if (m_Style == ProgressStyle::None)
  {
    return;
  }
  filter->AddObserver(itk::ProgressEvent(),
                      [this, filter, phaseOf = std::move(phaseOfFilter)](const itk::EventObject &) {
                        const std::string                 phase = phaseOf ? phaseOf() : std::string();
                        const std::lock_guard<std::mutex> lock(m_Mutex);
                        const bool                        isNew = !phase.empty() && phase != m_Phase;
                        if (isNew)
                        {
                          this->ChangePhase(phase);
                        }
                        m_Percent = static_cast<int>(100.0 * static_cast<double>(filter->GetProgress()) + 0.5);
                        // The ticker shows the percents as lines.
                        if (isNew || m_Style == ProgressStyle::Bar)
                        {
                          this->Show();
                        }
                      });
}

void
ProgressBar::End()
{
  const std::lock_guard<std::mutex> lock(m_Mutex);
  this->ChangePhase("");
  m_Shown.clear();
  if (m_Style == ProgressStyle::Bar)
  {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
  }
}

void
ProgressBar::ChangePhase(const std::string & phase)
{
  const auto now = Clock::now();
  if (m_Style == ProgressStyle::Slicer && !m_Phase.empty())
  {
    const double seconds = std::chrono::duration<double>(now - m_PhaseStart).count();
    std::printf("<filter-end>\n<filter-name>%s</filter-name>\n<filter-time>%.3f</filter-time>\n</filter-end>\n",
                m_Phase.c_str(),
                seconds);
  }
  m_Phase = phase;
  m_PhaseStart = now;
  if (!phase.empty() || std::uncaught_exceptions() == 0)
  {
    SetLastPhase(phase);
  }
  if (m_Style == ProgressStyle::Slicer && !phase.empty())
  {
    std::printf("<filter-start>\n<filter-name>%s</filter-name>\n<filter-comment>%s</filter-comment>\n</filter-start>\n",
                phase.c_str(),
                phase.c_str());
  }
  std::fflush(stdout);
}

std::string
ProgressBar::GetLastPhase()
{
  const std::lock_guard<std::mutex> lock(lastPhaseMutex);
  return lastPhase;
}

void
ProgressBar::Tick()
{
  std::unique_lock<std::mutex> lock(m_Mutex);
  while (!m_Stopping.wait_for(lock, std::chrono::seconds(1), [this] { return m_IsStopping; }))
  {
    this->Show();
  }
}

void
ProgressBar::Show()
{
  if (m_Style == ProgressStyle::None || m_Phase.empty())
  {
    return;
  }
  constexpr int     width = 40;
  const auto        seconds = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - m_Start).count();
  const std::string done(static_cast<std::size_t>(width * m_Percent / 100), '#');
  char              text[200];
  if (m_Style == ProgressStyle::Bar)
  {
    std::snprintf(text,
                  sizeof(text),
                  "\r\033[K%-28.60s [%-*s] %3d %% %4lld s",
                  m_Phase.c_str(),
                  width,
                  done.c_str(),
                  m_Percent,
                  static_cast<long long>(seconds));
  }
  else if (m_Style == ProgressStyle::Slicer)
  {
    std::snprintf(text, sizeof(text), "<filter-progress>%d.%02d</filter-progress>\n", m_Percent / 100, m_Percent % 100);
  }
  else
  {
    std::snprintf(
      text, sizeof(text), "%lld s: %.60s, %d %%\n", static_cast<long long>(seconds), m_Phase.c_str(), m_Percent);
  }
  if (m_Shown != text)
  {
    m_Shown = text;
    std::FILE * const stream = m_Style == ProgressStyle::Slicer ? stdout : stderr;
    std::fputs(text, stream);
    std::fflush(stream);
  }
}
} // namespace tissue
