/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Optimization/DelaunayDeviation.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <cmath>
#include <utility>

namespace tissue
{
namespace
{
/** The error a volume, sum |e|^2 / 20, of the tetrahedra that add 0 to the deviation, in squared spacings. The regular
 * one of them has edges of sqrt(1.5) spacings. At 0.40 and 0.50 the paper's preset for points gains half as much on the
 * cleaned complex, and loses on some tissues. */
constexpr double NeutralError = 0.45;
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
  const double  volume = Dot(normal, m_Centers[vertices[3]] - origin) / 6.0;
  const double  spacing = std::sqrt(squaredSpacing);
  return (std::abs(volume) * squaredLengths / (20.0 * squaredSpacing) - NeutralError * volume) /
         (squaredSpacing * spacing);
}
} // namespace tissue
