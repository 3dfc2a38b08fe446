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
#include <stdexcept>

namespace tissue
{
namespace
{
using Writer = void (*)(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels,
                        const ProjectedData & data, const std::string & path);

/** Writes the surfaces of the chosen cells. */
template <void (*TWrite)(const std::vector<ExportedCell> &, const std::string &)>
void
WriteCells(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels,
           const ProjectedData &, const std::string & path)
{
  TWrite(CollectExportedCells(mesh, cells, labels), path);
}

void
WriteWalls(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> &,
           const ProjectedData & data, const std::string & path)
{
  WriteCellComplexPly(mesh, cells, data, path);
}

/** By the ends of their names; of two that a name ends in, the longer one comes first. */
const std::vector<std::pair<std::string, Writer>> formats{ { ".mgx.ply", WriteCells<WriteFaceLabelPly> },
                                                           { ".ply", WriteWalls },
                                                           { ".glb", WriteCells<WriteGltfBinary> },
                                                           { ".obj", WriteCells<WriteWavefront> },
                                                           { ".stl", WriteCells<WriteStl> } };

bool
EndsWith(const std::string & text, const std::string & ending)
{
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}
} // namespace

std::vector<std::string>
MeshExportEndings()
{
  std::vector<std::string> endings;
  for (const auto & [ending, write] : formats)
  {
    endings.push_back(ending);
  }
  return endings;
}

void
ExportMesh(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels,
           const ProjectedData & data, const std::string & format, const std::string & path)
{
  const auto found = std::find_if(
    formats.begin(), formats.end(), [&format](const auto & known) { return EndsWith(format, known.first); });
  if (found == formats.end())
  {
    throw std::invalid_argument("ExportMesh: unknown format of " + format);
  }
  found->second(mesh, cells, labels, data, path);
}
} // namespace tissue
