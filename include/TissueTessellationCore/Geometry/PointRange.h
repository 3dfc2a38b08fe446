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
/** \brief Refuses points with whose distances, raised to the powers that volumes need, doubles cannot work.
 *
 * Coordinates must be finite and at most 1e30 in size, and the points must extend over at least 1e-30.
 * \param nameOf names the point of an index, for the message.
 * \throws std::invalid_argument for points that do not. */
void
RequirePointRange(const std::vector<Point> & points, const std::function<std::string(std::size_t)> & nameOf);

/** Returns the index of the first point that is outside of the box, whose sides belong to it; nothing where there is no
 * such point. */
std::optional<std::size_t>
FindPointOutside(const std::vector<Point> & points, const Box & box);
} // namespace tissue

#endif
