/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Legality_h
#define TissueTessellationCore_Legality_h

namespace tissue
{
/** The rule that says which operations are legal. */
enum class Legality
{
  /** The complex stays a closed simplicial 3-manifold: no edge and no triangle is made that exists already. */
  Combinatorial,
  /** In addition, every created tetrahedron is positively oriented. Positions are the cell centres, and for the
   * exterior its place relative to the element that is replaced (paper, sections 3.2 and 3.3). */
  Geometric
};
} // namespace tissue

#endif
