/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkSyntheticTissueEnums.h"

namespace itk
{
std::ostream &
operator<<(std::ostream & os, SyntheticTissueEnums::Shape shape)
{
  const char * const names[] = { "Block", "Dome", "Flower" };
  return os << names[static_cast<unsigned int>(shape)];
}

std::ostream &
operator<<(std::ostream & os, SyntheticTissueEnums::CellModel model)
{
  const char * const names[] = { "Voronoi", "Anisotropic", "Division" };
  return os << names[static_cast<unsigned int>(model)];
}
} // namespace itk
