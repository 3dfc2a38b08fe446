/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_MoveParts_h
#define TissueTessellationCore_MoveParts_h

#include "Nerve/GeneralMove.h"

#include <algorithm>

/** What the moves of a general complex are put together from. */
namespace tissue
{
inline VertexPair
Ascending(VertexId u, VertexId v)
{
  return { { std::min(u, v), std::max(u, v) } };
}

inline LineId
LineOf(const GeneralComplex & complex, const Side & side)
{
  return complex.GetTetrahedron(side.tetrahedron).lines[side.opposite];
}

inline Side
CreatedSide(std::size_t k, int opposite)
{
  return { GeneralMove::Created(k), opposite };
}

inline VertexPair
EndsOf(const GeneralComplex & complex, const EdgeRing & ring)
{
  const VertexQuadruple & t = complex.GetTetrahedron(ring[0].tetrahedron).vertices;
  return { { t[ring[0].from], t[ring[0].to] } };
}

} // namespace tissue

#endif
