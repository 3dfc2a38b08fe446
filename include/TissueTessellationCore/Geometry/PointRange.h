/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_PointRange_h
#define TissueTessellationCore_PointRange_h

#include "TissueTessellationCore/Geometry/Box.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** \brief Throws std::invalid_argument for points whose distances, cubed, are no good doubles.
 *
 * Coordinates must be finite and at most 1e30 in size, and the points must extend over 1e-30 at least.
 * \param nameOf the point of an index, for the message. */
void
RequirePointRange(const std::vector<Point> & points, const std::function<std::string(std::size_t)> & nameOf);

/** The first point that is outside of the box, its sides included in it. */
std::optional<std::size_t>
FindPointOutside(const std::vector<Point> & points, const Box & box);
} // namespace tissue

#endif
