/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/DelaunayDeviation.h"

#include "TissueTessellationCore/Vector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tissue
{
namespace
{
/** Of a regular tetrahedron whose edges are sqrt(1.5) = 1.22 spacings, in squares of these. */
constexpr double ErrorOfLargest = 0.45;
} // namespace

DelaunayDeviation::DelaunayDeviation(const std::vector<Point> & centers, std::vector<double> spacings)
  : m_Centers(centers)
  , m_SquaredSpacings(std::move(spacings))
{
  for (double & spacing : m_SquaredSpacings)
  {
    spacing *= spacing;
  }
}

double
DelaunayDeviation::Of(const VertexQuadruple & vertices) const
{
  double squaredLengths = 0.0;
  double squaredSpacing = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    if (vertices[i] == ExteriorVertex)
    {
      return 0.0;
    }
    squaredSpacing += 0.25 * m_SquaredSpacings[vertices[i]];
    for (int j = i + 1; j < 4; ++j)
    {
      const Point edge = m_Centers[vertices[j]] - m_Centers[vertices[i]];
      squaredLengths += Dot(edge, edge);
    }
  }
  const Point & origin = m_Centers[vertices[0]];
  const Point   normal = Cross(m_Centers[vertices[1]] - origin, m_Centers[vertices[2]] - origin);
  const double  volume = std::abs(Dot(normal, m_Centers[vertices[3]] - origin)) / 6.0;
  const double  spacing = std::sqrt(squaredSpacing);
  return volume / (squaredSpacing * spacing) * (squaredLengths / (20.0 * squaredSpacing) - ErrorOfLargest);
}
} // namespace tissue
