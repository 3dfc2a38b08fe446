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
  if (unit.empty())
  {
    return "unit";
  }
  return unit == "micrometres" ? "µm" : unit == "millimetres" ? "mm" : unit;
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
