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
/** The rule that says where the corners of the cells are put. */
enum class CornerRule
{
  /** A corner is at the paper's transform g of the cell centres. */
  ProjectedCircumcenter,
  /** A corner is at the transform g, but those at the exterior are on the tissue's surface (SurfaceLift.h). */
  LiftedCircumcenter,
  /** A corner is at the image's junction of its four cells, or else at the mean of its neighbours. */
  ImageJunction
};
} // namespace tissue

#endif
