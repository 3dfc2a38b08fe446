/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointUnits_h
#define PointUnits_h

#include "TissueTessellationCore/Common/Types.h"

#include <itkImageBase.h>

#include <string>
#include <vector>

namespace tissue
{
/** \brief Refuses points that can hardly be in the unit of their box.
 *
 * They are such where they extend over less than a hundredth of the box along each of its axes, or where some are
 * outside and they extend over 1.2 of it or more along one. The message has both extents, the box's voxels, and what
 * units the ratio of the extents suggests.
 * \param pointUnit of the points' lengths, boxUnit of the box's; empty where it is not known.
 * \throws std::runtime_error */
void
RequireUnitOfBox(const std::vector<Point> & points, const std::string & pointUnit, const itk::ImageBase<3> * box,
                 const std::string & boxUnit);
} // namespace tissue

#endif
