/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Exports/MeshExport.h"

#include "Shared/Exports/CellComplexPly.h"
#include "Shared/Exports/ExportedCells.h"
#include "Shared/Exports/GltfBinary.h"
#include "Shared/Exports/SurfaceFiles.h"

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace tissue
{
namespace
{
bool
EndsWith(const std::string & text, const std::string & ending)
{
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}
} // namespace

const std::vector<std::string> &
MeshExportEndings()
{
  // Of two that a name ends in, the longer one comes first.
  static const std::vector<std::string> endings{ ".mgx.ply", ".ply", ".glb", ".obj", ".stl" };
  return endings;
}

void
ExportMesh(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels,
           const std::string & format, const std::string & path)
{
  const auto & endings = MeshExportEndings();
  const auto   ending =
    std::find_if(endings.begin(), endings.end(), [&](const std::string & known) { return EndsWith(format, known); });
  if (ending == endings.end())
  {
    throw std::invalid_argument("ExportMesh: unknown format of " + format);
  }
  const std::vector<ExportedCell> exported = CollectExportedCells(mesh, cells, labels);
  if (*ending == ".ply")
  {
    WriteCellComplexPly(mesh, cells, path);
  }
  else
  {
    using Writer = std::function<void(const std::vector<ExportedCell> &, const std::string &)>;
    const std::vector<std::pair<std::string, Writer>> writers{
      { ".mgx.ply", WriteFaceLabelPly }, { ".glb", WriteGltfBinary }, { ".obj", WriteWavefront }, { ".stl", WriteStl }
    };
    const auto writer =
      std::find_if(writers.begin(), writers.end(), [&](const auto & known) { return known.first == *ending; });
    writer->second(exported, path);
  }
}
} // namespace tissue
