/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PictureLegend_h
#define PictureLegend_h

#include "Shared/Pictures/ColorScale.h"

#include <array>
#include <string>

class vtkRenderer;

namespace tissue
{
/** The height of a legend, as a part of the picture's. */
constexpr double LegendHeight = 0.17;

/** \brief Adds what the colours mean at the lower right: a title above a bar with numbers, or above the names of
 * categories; and what is grey, where a cell is.
 *
 * \param size of the picture in pixels, as rendered. */
void
AddLegend(vtkRenderer * renderer, const ColorScale & scale, const std::string & title, const std::array<int, 2> & size);
} // namespace tissue

#endif
