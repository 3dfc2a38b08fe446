/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkLabelVolume_h
#define itkLabelVolume_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Image/LabelIndexer.h"
#include "TissueTessellationCore/Image/LabelVolume.h"
#include "itkEnclosedVoidImageFilter.h"

#include <algorithm>
#include <memory>
#include <unordered_map>

namespace itk
{
/** Gives the voxels of the enclosed voids the vertices of their voids. */
template <typename TLabelImage>
void
NumberVoids(const TLabelImage * image, const tissue::JunctionSet & junctions, std::vector<tissue::VertexId> & vertices)
{
  const auto                   isZero = [](const tissue::Cell & cell) { return cell.label == 0; };
  const tissue::ExteriorLabels exterior{
    true,
    junctions.cells[tissue::ExteriorVertex].label,
    std::any_of(junctions.cells.begin() + 1, junctions.cells.end(), isZero),
  };
  const auto voids = EnclosedVoidImageFilter<TLabelImage>::New();
  voids->SetInput(image);
  voids->SetExteriorLabels(&exterior);
  voids->Update();
  const auto * const numbers = voids->GetOutput()->GetBufferPointer();
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (numbers[i] > 0)
    {
      vertices[i] = static_cast<tissue::VertexId>(junctions.cells.size() + numbers[i] - 1);
    }
  }
}

/** The label image as the core reads it: each voxel by the vertex of its cell in the junctions of the image. A label
 * that is no cell's is the exterior's, unless it is in an enclosed void of the junctions. */
template <typename TLabelImage>
std::shared_ptr<const tissue::LabelVolume>
MakeLabelVolume(const TLabelImage * image, const tissue::JunctionSet & junctions)
{
  using PixelType = typename TLabelImage::PixelType;
  const auto volume = std::make_shared<tissue::LabelVolume>();
  const auto region = image->GetLargestPossibleRegion();
  const auto physical = image->template TransformIndexToPhysicalPoint<double>(region.GetIndex());
  for (unsigned int i = 0; i < 3; ++i)
  {
    volume->size[i] = static_cast<std::int32_t>(region.GetSize(i));
    volume->origin[i] = physical[i];
    for (unsigned int j = 0; j < 3; ++j)
    {
      volume->steps[i][j] = image->GetDirection()[j][i] * image->GetSpacing()[i];
    }
  }
  std::unordered_map<tissue::Label, tissue::VertexId> vertexOf;
  for (std::size_t v = 1; v < junctions.cells.size(); ++v)
  {
    vertexOf[junctions.cells[v].label] = static_cast<tissue::VertexId>(v);
  }
  const PixelType * const pixels = image->GetBufferPointer();
  volume->vertices.resize(region.GetNumberOfPixels());
  PixelType        recent{};
  tissue::VertexId vertex = -1;
  for (std::size_t i = 0; i < volume->vertices.size(); ++i)
  {
    if (vertex < 0 || pixels[i] != recent)
    {
      recent = pixels[i];
      const auto found = vertexOf.find(static_cast<tissue::Label>(recent));
      vertex = found != vertexOf.end() ? found->second : tissue::ExteriorVertex;
    }
    volume->vertices[i] = vertex;
  }
  if (!junctions.voids.empty())
  {
    NumberVoids(image, junctions, volume->vertices);
  }
  return volume;
}
} // namespace itk

#endif
