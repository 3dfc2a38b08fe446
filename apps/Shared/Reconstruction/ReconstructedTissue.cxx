/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/ReconstructedTissue.h"

#include "Shared/CommandLine/RunProgram.h"
#include "TissueTessellationCore/Common/Stopwatch.h"
#include "itkJunctionsToCellWallMeshFilter.h"

namespace tissue
{
namespace
{
itk::CellWallMesh::Pointer
MakeMesh(const TissueInput & input, itk::TissueLabelVolume::Pointer volume, const ReconstructionParameters & parameters,
         ProgressBar & progress)
{
  const auto filter = itk::JunctionsToCellWallMeshFilter::New();
  filter->SetInput(input.extracted.junctions);
  filter->SetParameters(parameters);
  filter->SetLabelVolume(volume);
  progress.Begin("Finding the complex");
  progress.Observe(filter, [mesher = filter.GetPointer()]() { return std::string(mesher->GetPhase()); });
  filter->Update();
  return filter->GetOutput();
}
} // namespace

ReconstructedTissue
Reconstruct(const TissueInput & input, itk::TissueLabelVolume::Pointer volume,
            const ReconstructionParameters & parameters, ProgressBar & progress)
{
  return WithFileName(input.file, [&] {
    ReconstructedTissue tissue;
    tissue.mesh = MakeMesh(input, std::move(volume), parameters, progress);
    Stopwatch           timer;
    const JunctionSet & junctions = input.GetJunctionSet();
    const WallMesh &    walls = tissue.mesh->GetWallMesh();
    tissue.check = CheckCellSurfaces(walls, junctions.NumberOfVertices());
    tissue.statistics = MeasureTissue(walls, junctions.cells, junctions.grid);
    tissue.checkSeconds = timer.Lap().wallSeconds;
    return tissue;
  });
}
} // namespace tissue
