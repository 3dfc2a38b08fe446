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
/** Time on the wall, and of all of the program's threads on the processors, which other programs disturb less. */
struct ElapsedTime
{
  double wallSeconds = 0.0;
  double processorSeconds = 0.0;
};

class Stopwatch
{
public:
  /** Since the last call or the start. */
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
