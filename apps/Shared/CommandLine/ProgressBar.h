/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ProgressBar_h
#define ProgressBar_h

#include <itkProcessObject.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace tissue
{
/** How progress is shown, on standard error. */
enum class ProgressStyle
{
  None,
  /** A bar that is drawn over and over again, for a terminal. */
  Bar,
  /** Lines, one a second at most, for a file: "12 s: Fitting the walls, 28 %". */
  Lines
};

/** By its name, "none", "bar" or "lines"; "auto" is the bar where standard error is a terminal, none elsewhere. */
ProgressStyle
ChooseProgressStyle(const std::string & name);

/** \brief Shows the progress of the phases of a program on standard error, with the seconds since it began.
 *
 * What is shown moves every second, by the seconds at least, however long a step takes. */
class ProgressBar
{
public:
  explicit ProgressBar(ProgressStyle style);
  ~ProgressBar();
  ProgressBar(const ProgressBar &) = delete;
  ProgressBar &
  operator=(const ProgressBar &) = delete;

  /** Begins a phase of this name. */
  void
  Begin(const std::string & phase);

  /** Shows the progress of a filter as that of the phase; the bar must outlive the filter's execution.
   * \param phaseOfFilter tells the phase, where that changes while the filter runs; where it is empty the phase goes
   * on.
   */
  void
  Observe(itk::ProcessObject * filter, std::function<std::string()> phaseOfFilter = {});

  /** Removes the bar from the terminal. */
  void
  End();

private:
  using Clock = std::chrono::steady_clock;

  void
  Tick();

  /** Shows how far it is, where that has changed. The mutex must be held. */
  void
  Show();

  const ProgressStyle     m_Style;
  const Clock::time_point m_Start = Clock::now();
  std::mutex              m_Mutex;
  std::condition_variable m_Stopping;
  bool                    m_IsStopping = false;
  /** Empty between phases. */
  std::string m_Phase;
  int         m_Percent = 0;
  std::string m_Shown;
  std::thread m_Ticker;
};
} // namespace tissue

#endif
