/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_TissueShapes_h
#define TissueTessellationCore_TissueShapes_h

#include "TissueTessellationCore/Common/Types.h"

namespace tissue
{
/** \name Shapes of synthetic tissues
 * Each function tells whether a point is in the shape, which stands upright along the third axis in the cube [-1, 1]^3
 * and touches its six sides.
 * @{ */

/** A meristem: a high dome on a low, rounded base, 0.52 of the cube. */
bool
IsInsideDome(const Point & point);

/** A flower bud: four upright sepals around a central dome, with deep concavities between them. */
bool
IsInsideFlower(const Point & point);
/** @} */
} // namespace tissue

#endif
