/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_CornerRule_h
#define TissueTessellationCore_CornerRule_h

namespace tissue
{
/** Where the corners of the cells are put. */
enum class CornerRule
{
  /** The paper's transform g of the cell centres. */
  ProjectedCircumcenter,
  /** Likewise, but those at the exterior where the surface of the tissue is (SurfaceLift.h). */
  LiftedCircumcenter,
  /** The junction of the image where it has one of the same four cells; the mean of the neighbouring corners elsewhere.
   */
  ImageJunction
};
} // namespace tissue

#endif
