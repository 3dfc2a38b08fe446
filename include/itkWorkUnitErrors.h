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
 * An exception that leaves a work unit, such as that of an abort, may get lost in a pool of threads, or destroy what
 * the other threads still use. This class keeps it until all are done.
 *
 * \ingroup TissueTessellation
 */
class WorkUnitErrors
{
public:
  /** Runs the work of a unit, and keeps the exception that leaves it. Of several it keeps the last. */
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

  /** Throws the exception that was kept. It is to be called when all work units are done. */
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
