/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ProgressBar_h
#define ProgressBar_h

#include <itkProcessObject.h>

#include <string>

namespace tissue
{
/** \brief Shows the progress of the phases of a program on a terminal, on standard error.
 *
 * Silent where standard error is no terminal, or where it is told so. */
class ProgressBar
{
public:
  explicit ProgressBar(bool isQuiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar &) = delete;
  ProgressBar &
  operator=(const ProgressBar &) = delete;

  /** Begins a phase of this name. */
  void
  Begin(const std::string & phase);

  /** Shows the progress of a filter as that of the phase; the bar must outlive the filter's execution. */
  void
  Observe(itk::ProcessObject * filter);

  /** Removes the bar from the terminal. */
  void
  End();

private:
  void
  Show(double fraction);

  bool        m_IsActive;
  int         m_Percent = -1;
  std::string m_Phase;
};
} // namespace tissue

#endif
