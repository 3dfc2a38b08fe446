/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructionModule.h"

#include "Shared/Reconstruction/MethodOptions.h"

namespace tissue
{
namespace
{
struct ModuleResult
{
  SlicerResult description;
  double (*measure)(const ReconstructionReport & report);
};

const std::vector<ModuleResult> &
GetModuleResults()
{
  using Report = ReconstructionReport;
  static const std::vector<ModuleResult> results{
    { { "numberOfCells", "integer", "Cells of the mesh" },
      [](const Report & r) { return static_cast<double>(r.GetCells().size() - 1); } },
    { { "numberOfTriangles", "integer", "Triangles of the mesh, each counted once" },
      [](const Report & r) { return static_cast<double>(r.GetReconstruction().walls.triangles.size()); } },
    { { "numberOfFaults", "integer", "Kinds of faults of the mesh; the module's output says which" },
      [](const Report & r) { return static_cast<double>(CollectFaults(r).size()); } },
    { { "meanVolumeError", "double", "Of the cells, of their volumes in the image, in percent" },
      [](const Report & r) { return 100.0 * MeasureVolumeErrors(r).value_or(VolumeErrors()).mean; } }
  };
  return results;
}
} // namespace

SlicerModule
MakeReconstructionModule(const std::string & title, const std::map<std::string, SlicerUse> & uses)
{
  SlicerModule module{ title, uses, {} };
  for (const std::string & name : { PresetOption, OtherPresetGroup, std::string("--strict") })
  {
    module.uses.emplace(name, SlicerUse::LeftOut);
  }
  module.uses.emplace("--evaluateAgainst", SlicerUse::LabelImage);
  module.uses.emplace("--signal", SlicerUse::Image);
  for (const ModuleResult & result : GetModuleResults())
  {
    module.results.push_back(result.description);
  }
  return module;
}

ReturnParameters
CollectResults(const ReconstructionReport & report)
{
  ReturnParameters parameters;
  for (const ModuleResult & result : GetModuleResults())
  {
    parameters.emplace_back(result.description.name, result.measure(report));
  }
  return parameters;
}
} // namespace tissue
