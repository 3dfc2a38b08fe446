/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkCoreParallelFor_h
#define itkCoreParallelFor_h

#include "TissueTessellationCore/ParallelFor.h"
#include "itkMultiThreaderBase.h"
#include "itkProcessObject.h"
#include "itkWorkUnitErrors.h"

namespace itk
{
/** The core's parallel loops by the threads of a filter, which must outlive what is returned. */
inline tissue::ParallelFor
MakeParallelFor(ProcessObject * filter)
{
  return [filter](std::size_t count, const std::function<void(std::size_t)> & body) {
    if (count == 0)
    {
      return;
    }
    WorkUnitErrors errors;
    filter->GetMultiThreader()->SetNumberOfWorkUnits(filter->GetNumberOfWorkUnits());
    filter->GetMultiThreader()->ParallelizeArray(
      0, count, [&](SizeValueType i) { errors.Run([&]() { body(i); }); }, nullptr);
    errors.Rethrow();
  };
}
} // namespace itk

#endif
