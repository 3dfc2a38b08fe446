/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/CellColors.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tissue
{
namespace
{
struct PaletteColor
{
  std::array<double, 3> lab;
  Color                 rgb;
};

/** Rings of hues in CIELAB, where distances are those the eye sees. */
std::vector<PaletteColor>
MakePalette()
{
  struct Ring
  {
    double lightness;
    double chroma;
    double firstHue;
  };
  constexpr int             huesPerRing = 12;
  std::vector<PaletteColor> palette;
  for (const Ring & ring : { Ring{ 78.0, 42.0, 0.0 }, Ring{ 90.0, 26.0, 15.0 }, Ring{ 66.0, 46.0, 15.0 } })
  {
    for (int i = 0; i < huesPerRing; ++i)
    {
      const double hue = vtkMath::RadiansFromDegrees(ring.firstHue + 360.0 * i / huesPerRing);
      PaletteColor color{ { { ring.lightness, ring.chroma * std::cos(hue), ring.chroma * std::sin(hue) } }, {} };
      double       rgb[3];
      vtkMath::LabToRGB(color.lab.data(), rgb);
      for (int c = 0; c < 3; ++c)
      {
        color.rgb[c] = static_cast<unsigned char>(std::lround(255.0 * std::clamp(rgb[c], 0.0, 1.0)));
      }
      palette.push_back(color);
    }
  }
  return palette;
}

/** Squared distance to the eye, up to the one beyond which two colours are different enough. */
double
Distance(const PaletteColor & a, const PaletteColor & b)
{
  constexpr double enough = 45.0;
  return std::min(vtkMath::Distance2BetweenPoints(a.lab.data(), b.lab.data()), enough * enough);
}
} // namespace

std::vector<Color>
ChooseCellColors(const WallMesh & mesh, VertexId numberOfVertices)
{
  std::vector<std::vector<VertexId>> neighbors(numberOfVertices);
  for (const WallMesh::Wall & wall : mesh.walls)
  {
    neighbors[wall.cells[0]].push_back(wall.cells[1]);
    neighbors[wall.cells[1]].push_back(wall.cells[0]);
  }
  const std::vector<PaletteColor> palette = MakePalette();
  std::vector<int>                uses(palette.size(), 0);
  std::vector<std::size_t>        chosen(numberOfVertices);
  std::vector<Color>              colors(numberOfVertices);
  for (VertexId v = ExteriorVertex + 1; v < numberOfVertices; ++v)
  {
    double bestDistance = -1.0;
    for (std::size_t i = 0; i < palette.size(); ++i)
    {
      double distance = std::numeric_limits<double>::max();
      for (const VertexId neighbor : neighbors[v])
      {
        if (neighbor != ExteriorVertex && neighbor < v)
        {
          distance = std::min(distance, Distance(palette[i], palette[chosen[neighbor]]));
        }
      }
      if (distance > bestDistance || (distance == bestDistance && uses[i] < uses[chosen[v]]))
      {
        bestDistance = distance;
        chosen[v] = i;
      }
    }
    ++uses[chosen[v]];
    colors[v] = palette[chosen[v]].rgb;
  }
  return colors;
}
} // namespace tissue
