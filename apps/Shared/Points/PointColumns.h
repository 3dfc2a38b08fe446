/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointColumns_h
#define PointColumns_h

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tissue
{
/** Which columns of a table of points hold what. */
struct PointColumns
{
  std::array<std::size_t, 3> coordinates = { { 0, 1, 2 } };
  std::optional<std::size_t> label;
};

/** \brief Finds the columns of the coordinates, and of the labels if there is one, by their names.
 *
 * Of x: "x", "x_um", "X (microns)", "CenterX", "centroid_x", "Position X [µm]" and alike, in small letters or capitals.
 * \throws std::runtime_error: an axis without a column or with two, axes of different units, and columns that are
 * numbered, as by scikit-image, where 0 is the first axis of an array: mostly z. */
PointColumns
FindPointColumns(const std::vector<std::string> & names);
} // namespace tissue

#endif
