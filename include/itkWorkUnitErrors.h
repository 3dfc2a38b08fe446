/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkWorkUnitErrors_h
#define itkWorkUnitErrors_h

#include <exception>
#include <mutex>

namespace itk
{
/** \class WorkUnitErrors
 * \brief Carries an exception out of parallel work units.
 *
 * An exception, such as that of an abort, that leaves a work unit may get lost in a pool of threads, or unwind what the
 * other threads still use. Here it waits until all are done.
 *
 * \ingroup TissueTessellation
 */
class WorkUnitErrors
{
public:
  /** Runs the work of a unit, and keeps the exception that leaves it; of several, the last. */
  template <typename TWork>
  void
  Run(const TWork & work)
  {
    try
    {
      work();
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(m_Mutex);
      m_Error = std::current_exception();
    }
  }

  /** To be called when all work units are done: throws what was kept. */
  void
  Rethrow() const
  {
    if (m_Error)
    {
      std::rethrow_exception(m_Error);
    }
  }

private:
  std::mutex         m_Mutex;
  std::exception_ptr m_Error;
};
} // namespace itk

#endif
