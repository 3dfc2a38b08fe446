/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Page/ColumnUnit.h"

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
  static const std::map<std::string, const char *> powers{ { "CenterX", "" },
                                                           { "CenterY", "" },
                                                           { "CenterZ", "" },
                                                           { "Volume", "³" },
                                                           { "ImageVolume", "³" },
                                                           { "SurfaceArea", "²" },
                                                           { "ExteriorArea", "²" },
                                                           { "CutArea", "²" },
                                                           { "MajorAxisLength", "" },
                                                           { "MiddleAxisLength", "" },
                                                           { "MinorAxisLength", "" },
                                                           { "MeanCurvature", "⁻¹" },
                                                           { "MaximumCurvature", "⁻¹" },
                                                           { "MinimumCurvature", "⁻¹" },
                                                           { "GaussianCurvature", "⁻²" } };
  if (column == "MinimumDihedralAngle")
  {
    return "°";
  }
  const auto power = powers.find(column);
  return power == powers.end() ? std::string() : length + power->second;
}
} // namespace tissue
