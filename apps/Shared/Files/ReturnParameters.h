/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReturnParameters_h
#define ReturnParameters_h

#include <string>
#include <utility>
#include <vector>

namespace tissue
{
/** Numbers by name, in an order. */
using ReturnParameters = std::vector<std::pair<std::string, double>>;

/** Writes the results of a program for 3D Slicer: a line "name = value" each, the number without an exponent, with six
 * digits after the point at most, as people read it. \throws std::runtime_error where it cannot. */
void
WriteReturnParameters(const ReturnParameters & parameters, const std::string & path);
} // namespace tissue

#endif
