/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_DelaunayDeviation_h
#define TissueTessellationCore_DelaunayDeviation_h

#include "Complex/AdjacencyComplex.h"

#include <vector>

namespace tissue
{
/** \brief What a tetrahedron adds to the deviation of a complex from the Delaunay tetrahedralization.
 *
 * Of all tetrahedralizations of the same points, the Delaunay one interpolates the function |x|^2 with the least error,
 * which is V sum |e|^2 / 20 over a tetrahedron of volume V and edges e (optimal Delaunay triangulations, Alliez et al.
 * 2005, doi:10.1145/1073204.1073238). Here it is in units of the local spacing s (root mean square of the four
 * vertices'), less a constant by the volume: (|V| sum |e|^2 / 20 - 0.45 V s^2) / s^5, V below 0 where the tetrahedron
 * is inverted. Where all vertices have one spacing, the least error is Delaunay's, and the volumes add up to the same
 * over any tetrahedralization of one region; where the surface can move, tetrahedra about as large as those inside are
 * worth having, and larger ones are not.
 *
 * A tetrahedron with the exterior, which has no position, adds 0. */
class DelaunayDeviation
{
public:
  /** \param centers positions of the vertices, which must outlive this object.
   * \param spacings of each vertex, above 0 but for the exterior (LocalSpacing.h). */
  DelaunayDeviation(const std::vector<Point> & centers, std::vector<double> spacings);

  /** Without a unit. */
  double
  Of(const VertexQuadruple & vertices) const;

private:
  const std::vector<Point> & m_Centers;
  std::vector<double>        m_SquaredSpacings;
};
} // namespace tissue

#endif
