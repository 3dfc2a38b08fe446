/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/ColumnUnit.h"

#include <cstdlib>
#include <map>

namespace tissue
{
std::string
LengthSymbol(const std::string & unit)
{
  static const std::map<std::string, const char *> symbols{ { "", "unit" },          { "units", "unit" },
                                                            { "voxels", "voxel" },   { "um", "µm" },
                                                            { "micrometres", "µm" }, { "millimetres", "mm" } };
  const auto                                       symbol = symbols.find(unit);
  return symbol == symbols.end() ? unit : symbol->second;
}

std::string
ColumnUnit(const std::string & column, const std::string & length)
{
  static const std::map<std::string, int> powers{
    { "CenterX", 1 },           { "CenterY", 1 },           { "CenterZ", 1 },           { "Volume", 3 },
    { "ImageVolume", 3 },       { "SurfaceArea", 2 },       { "ExteriorArea", 2 },      { "CutArea", 2 },
    { "MajorAxisLength", 1 },   { "MiddleAxisLength", 1 },  { "MinorAxisLength", 1 },   { "MeanCurvature", -1 },
    { "MaximumCurvature", -1 }, { "MinimumCurvature", -1 }, { "GaussianCurvature", -2 }
  };
  static const char * const exponents[] = { "", "", "²", "³" };
  const auto                power = powers.find(column);
  if (power == powers.end())
  {
    return column == "MinimumDihedralAngle" ? "°" : "";
  }
  return (power->second < 0 ? "1/" : "") + length + exponents[std::abs(power->second)];
}
} // namespace tissue
