/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_GeneralValidity_h
#define TissueTessellationCore_GeneralValidity_h

#include "Nerve/GeneralComplex.h"

#include <string>
#include <vector>

namespace tissue
{
/** \brief Everything that is wrong with a general complex, each violation as one sentence; empty for a valid one.
 *
 * Checked from scratch: four different vertices a tetrahedron; gluings mutual and across triangles of the same
 * vertices, with opposite orientations; the same line from both sides; then the links, if all that is in order: of
 * every cell one sphere, of the outside vertices any number of closed surfaces of any genus. */
std::vector<std::string>
FindViolations(const GeneralComplex & complex);
} // namespace tissue

#endif
