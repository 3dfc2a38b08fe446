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
/** \brief Computes what a tetrahedron adds to the deviation of a complex from the Delaunay tetrahedralization.
 *
 * Of all tetrahedralizations of the same points, the Delaunay one interpolates the function |x|^2 with the least error,
 * which is V sum |e|^2 / 20 over a tetrahedron of volume V and edges e (optimal Delaunay triangulations, Alliez et al.
 * 2005, doi:10.1145/1073204.1073238). Here it is in units of the local spacing s, the root mean square of the four
 * vertices' spacings, less a constant times the volume: (|V| sum |e|^2 / 20 - 0.45 V s^2) / s^5, where V is below 0 for
 * an inverted tetrahedron. Where all vertices have one spacing, Delaunay's sum of errors is the least, and the volumes
 * add up to the same over any tetrahedralization of one region. Where the surface can move, tetrahedra about as large
 * as those inside are worth having, and larger ones are not.
 *
 * A tetrahedron with the exterior, which has no position, adds 0. */
class DelaunayDeviation
{
public:
  /** \param centers the positions of the vertices, which must outlive this object.
   * \param spacings the local spacing of each vertex (LocalSpacing.h), above 0 except for the exterior. */
  DelaunayDeviation(const std::vector<Point> & centers, std::vector<double> spacings);

  /** Returns what the tetrahedron of these vertices adds; the number has no unit. */
  double
  Of(const VertexQuadruple & vertices) const;

private:
  const std::vector<Point> & m_Centers;
  std::vector<double>        m_SquaredSpacings;
};
} // namespace tissue

#endif
