/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LengthUnit_h
#define LengthUnit_h

#include <optional>
#include <string>

namespace tissue
{
/** Micrometres in a unit of length as programs of microscopy write it: its symbol or its English name, of nm, µm, mm,
 * cm, m, ångström and inch; µ in UTF-8 (either sign), in Latin-1, as u, or escaped as ImageJ does. Nothing for a pixel,
 * an empty unit, and all others. */
std::optional<double>
ToMicrometers(const std::string & unit);
} // namespace tissue

#endif
