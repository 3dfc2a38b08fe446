/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCoreExecution_h
#define itkCoreExecution_h

#include "TissueTessellationCore/Common/Execution.h"
#include "itkMultiThreaderBase.h"
#include "itkProcessObject.h"
#include "itkWorkUnitErrors.h"

#include <sstream>
#include <stdexcept>

namespace itk
{
/** The core's loops by the threads of the given object, which must outlive what is returned. */
inline tissue::Execution
MakeExecution(MultiThreaderBase * threader)
{
  return tissue::Execution([threader](std::size_t count, const tissue::Execution::LoopBody & body) {
    if (count == 0)
    {
      return;
    }
    WorkUnitErrors errors;
    threader->ParallelizeArray(
      0, count, [&](SizeValueType i) { errors.Run([&]() { body(i); }); }, nullptr);
    errors.Rethrow();
  });
}

/** The core's work within a filter, which must outlive what is returned: loops by the filter's threads, progress as the
 * filter's from `begin` to `end`, and stopped where the filter is to be aborted.
 * \param enterPhase is told the names of the phases. */
inline tissue::Execution
MakeExecution(ProcessObject * filter, float begin = 0.0f, float end = 1.0f,
              tissue::Execution::PhaseFunction enterPhase = {})
{
  return tissue::Execution(
    [filter](std::size_t count, const tissue::Execution::LoopBody & body) {
      filter->GetMultiThreader()->SetNumberOfWorkUnits(filter->GetNumberOfWorkUnits());
      MakeExecution(filter->GetMultiThreader()).For(count, body);
    },
    [filter, begin, end](double fraction) {
      filter->UpdateProgress(begin + (end - begin) * static_cast<float>(fraction));
      return !filter->GetAbortGenerateData();
    },
    std::move(enterPhase));
}

/** What `work` returns. The core's exceptions become ITK's: tissue::Aborted ProcessAborted, and those for input that it
 * refuses an ExceptionObject with the name of `object`. */
template <typename TWork>
auto
RunCore(const Object * object, const TWork & work) -> decltype(work())
{
  std::string refusal;
  try
  {
    return work();
  }
  catch (const ExceptionObject &)
  {
    throw;
  }
  catch (const tissue::Aborted &)
  {
    throw ProcessAborted(__FILE__, __LINE__);
  }
  catch (const std::invalid_argument & error)
  {
    refusal = error.what();
  }
  catch (const std::runtime_error & error)
  {
    refusal = error.what();
  }
  std::ostringstream message;
  message << "ITK ERROR: " << object->GetNameOfClass() << '(' << object << "): " << refusal;
  throw ExceptionObject(__FILE__, __LINE__, message.str(), ITK_LOCATION);
}
} // namespace itk

#endif
