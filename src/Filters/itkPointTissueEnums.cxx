/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkPointTissueEnums.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & os, PointTissueEnums::Layer layer)
{
  const char * const names[] = { "Automatic", "On", "Off" };
  return os << names[static_cast<unsigned int>(layer)];
}
} // namespace itk
