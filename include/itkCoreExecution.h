/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCoreParallelFor_h
#define itkCoreParallelFor_h

#include "TissueTessellationCore/Common/Execution.h"
#include "itkMultiThreaderBase.h"
#include "itkProcessObject.h"
#include "itkWorkUnitErrors.h"

namespace itk
{
/** The core's parallel loops by the threads of who calls, which must outlive what is returned. */
inline tissue::ParallelFor
MakeParallelFor(MultiThreaderBase * threader)
{
  return [threader](std::size_t count, const std::function<void(std::size_t)> & body) {
    if (count == 0)
    {
      return;
    }
    WorkUnitErrors errors;
    threader->ParallelizeArray(
      0, count, [&](SizeValueType i) { errors.Run([&]() { body(i); }); }, nullptr);
    errors.Rethrow();
  };
}

/** Likewise, by those of a filter. */
inline tissue::ParallelFor
MakeParallelFor(ProcessObject * filter)
{
  return [filter](std::size_t count, const std::function<void(std::size_t)> & body) {
    filter->GetMultiThreader()->SetNumberOfWorkUnits(filter->GetNumberOfWorkUnits());
    MakeParallelFor(filter->GetMultiThreader())(count, body);
  };
}
} // namespace itk

#endif
