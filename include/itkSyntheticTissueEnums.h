/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkSyntheticTissueEnums_h
#define itkSyntheticTissueEnums_h

#include "TissueTessellationExport.h"

#include <cstdint>
#include <ostream>

namespace itk
{
/** \class SyntheticTissueEnums
 * \brief Enumerations of SyntheticTissueImageSource.
 * \ingroup TissueTessellation */
class SyntheticTissueEnums
{
public:
  /** The outline of the tissue. */
  enum class Shape : uint8_t
  {
    /** A box: with a margin of 0 the whole image, which then has no exterior. */
    Block = 0,
    /** A meristem: a high dome on a low, rounded base. */
    Dome = 1,
    /** A flower bud: four sepals around a central dome, with deep concavities between them. */
    Flower = 2
  };

  /** How the tissue is made into cells. */
  enum class CellModel : uint8_t
  {
    /** Voronoi cells of relaxed seeds: convex cells with flat walls. */
    Voronoi = 0,
    /** Each cell is long and flat to its own degree, along its own directions: curved walls. */
    Anisotropic = 1,
    /** One Voronoi cell in 16 is a founder. The cells grow and divide by planes, largest cells first, roughly across
     * their longest directions. */
    Division = 2
  };
};

TissueTessellation_EXPORT std::ostream &
                          operator<<(std::ostream & os, SyntheticTissueEnums::Shape shape);

TissueTessellation_EXPORT std::ostream &
                          operator<<(std::ostream & os, SyntheticTissueEnums::CellModel model);
} // namespace itk

#endif
