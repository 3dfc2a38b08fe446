/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_LinkLoop_h
#define TissueTessellationCore_LinkLoop_h

#include "Nerve/LinkSurface.h"

namespace tissue
{
/** A closed path in the link of a vertex, by the triangles of the complex that are its edges, and the vertices of the
 * complex that its vertices lead to: triangle i has the vertices i and i + 1, cyclic. */
struct LinkLoop
{
  std::vector<Side>     triangles;
  std::vector<VertexId> vertices;
};

/** A short loop that does not cut the surface in two, so one around a handle: by a tree of shortest paths from each of
 * some vertices, and a tree of triangles that crosses no path, what is left are the edges that close such loops (J.
 * Erickson, K. Whittlesey, Greedy optimal homotopy and homology generators, SODA 2005). Empty on a sphere. */
LinkLoop
FindHandleLoop(const GeneralComplex & complex, const LinkSurface & surface);
} // namespace tissue

#endif
