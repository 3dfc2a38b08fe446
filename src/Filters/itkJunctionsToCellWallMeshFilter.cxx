/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkJunctionsToCellWallMeshFilter.h"

#include "TissueTessellationCore/Reconstruction/TissueReconstruction.h"
#include "itkCoreExecution.h"
#include "itkTissueJunctions.h"

namespace itk
{
JunctionsToCellWallMeshFilter::JunctionsToCellWallMeshFilter()
{
  this->SetNumberOfRequiredInputs(1);
}

void
JunctionsToCellWallMeshFilter::SetInput(const TissueJunctions * junctions)
{
  this->SetNthInput(0, const_cast<TissueJunctions *>(junctions));
}

const TissueJunctions *
JunctionsToCellWallMeshFilter::GetInput() const
{
  return itkDynamicCastInDebugMode<const TissueJunctions *>(this->GetPrimaryInput());
}

void
JunctionsToCellWallMeshFilter::SetLabelVolume(std::shared_ptr<const tissue::LabelVolume> volume)
{
  m_LabelVolume = std::move(volume);
  this->Modified();
}

void
JunctionsToCellWallMeshFilter::GenerateData()
{
  const auto junctions = std::make_shared<const tissue::JunctionSet>(this->GetInput()->GetJunctionSet());
  const auto reconstruction = std::make_shared<const tissue::TissueReconstruction>(RunCore(this, [&] {
    return tissue::ReconstructTissue(*junctions, this->GetParameters(), m_LabelVolume.get(), MakeExecution(this));
  }));
  this->GetOutput()->SetReconstruction(junctions, reconstruction);
}
} // namespace itk
