/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LapTimer_h
#define LapTimer_h

#include <itkTimeProbe.h>

namespace tissue
{
/** Seconds since the last call or the start. */
class LapTimer
{
public:
  LapTimer() { m_Probe.Start(); }

  double
  Lap()
  {
    m_Probe.Stop();
    const double seconds = m_Probe.GetTotal();
    m_Probe.Reset();
    m_Probe.Start();
    return seconds;
  }

private:
  itk::TimeProbe m_Probe;
};
} // namespace tissue

#endif
