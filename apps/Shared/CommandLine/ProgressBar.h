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
/** How progress is shown, on standard error but for Slicer. */
enum class ProgressStyle
{
  None,
  /** A bar that is drawn over and over again, for a terminal. */
  Bar,
  /** Lines, one a second at most, for a file: "12 s: Fitting the walls, 28 %". */
  Lines,
  /** On standard output, for 3D Slicer: each phase in its elements <filter-start> and <filter-end>, and between them
   * how far it is, 0 .. 1, in <filter-progress>, once a second at most. */
  Slicer
};

/** By its name, "none", "bar", "lines" or "slicer"; "auto" is the bar where standard error is a terminal, none
 * elsewhere. */
ProgressStyle
ChooseProgressStyle(const std::string & name);

/** \brief Shows the progress of the phases of a program, with the seconds since it began.
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

  /** Ends the phase; removes the bar from the terminal. */
  void
  End();

  /** The phase that a bar of the program is in, or was in when an exception ended it; empty between phases. */
  static std::string
  GetLastPhase();

private:
  using Clock = std::chrono::steady_clock;

  void
  Tick();

  /** Shows how far it is, where that has changed. The mutex must be held. */
  void
  Show();

  /** Begins a phase, or none, and ends the one before it. The mutex must be held. */
  void
  ChangePhase(const std::string & phase);

  const ProgressStyle     m_Style;
  const Clock::time_point m_Start = Clock::now();
  std::mutex              m_Mutex;
  std::condition_variable m_Stopping;
  bool                    m_IsStopping = false;
  /** Empty between phases. */
  std::string       m_Phase;
  Clock::time_point m_PhaseStart = m_Start;
  int               m_Percent = 0;
  std::string       m_Shown;
  std::thread       m_Ticker;
};
} // namespace tissue

#endif
