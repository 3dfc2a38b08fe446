/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Stopwatch_h
#define TissueTessellationCore_Stopwatch_h

#include <chrono>
#include <ctime>

namespace tissue
{
/** The time that has gone by on the clock, and the time that all threads of the program spent on the processors, which
 * other programs disturb less. Both are in seconds. */
struct ElapsedTime
{
  double wallSeconds = 0.0;
  double processorSeconds = 0.0;
};

/** \brief Measures times from lap to lap; it starts when it is made. */
class Stopwatch
{
public:
  /** Returns the time since the last call, or since the start. */
  ElapsedTime
  Lap()
  {
    const auto        wall = std::chrono::steady_clock::now();
    const auto        processor = std::clock();
    const ElapsedTime elapsed{ std::chrono::duration<double>(wall - m_Wall).count(),
                               static_cast<double>(processor - m_Processor) / CLOCKS_PER_SEC };
    m_Wall = wall;
    m_Processor = processor;
    return elapsed;
  }

private:
  std::chrono::steady_clock::time_point m_Wall = std::chrono::steady_clock::now();
  std::clock_t                          m_Processor = std::clock();
};
} // namespace tissue

#endif
