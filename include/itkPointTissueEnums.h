/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkPointTissueEnums_h
#define itkPointTissueEnums_h

#include "TissueTessellationExport.h"

#include <cstdint>
#include <ostream>

namespace itk
{
/** \class PointTissueEnums
 * \brief Enumerations of PointSetToTissueLabelImageFilter.
 * \ingroup TissueTessellation */
class PointTissueEnums
{
public:
  /** Whether the tissue is one layer of cells, a sheet or a shell. */
  enum class Layer : uint8_t
  {
    /** It is where the points show it. */
    Automatic = 0,
    On = 1,
    Off = 2
  };
};

TissueTessellation_EXPORT std::ostream &
                          operator<<(std::ostream & os, PointTissueEnums::Layer layer);
} // namespace itk

#endif
