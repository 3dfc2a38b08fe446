/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "LabelInput.h"

#include <itkConstantPadImageFilter.h>
#include <itkImageFileReader.h>
#include <itkUnaryGeneratorImageFilter.h>

#include <unordered_map>

namespace tissue
{
LabelImage::Pointer
ReadLabels(const std::string & path)
{
  const auto reader = itk::ImageFileReader<LabelImage>::New();
  reader->SetFileName(path);
  reader->Update();
  return reader->GetOutput();
}

LabelExtraction::Pointer
ExtractTissue(const LabelImage * labels)
{
  const auto extraction = LabelExtraction::New();
  extraction->SetInput(labels);
  extraction->GenerateLabelVolumeOn();
  extraction->Update();
  return extraction;
}

CellImage::Pointer
MakeCellImage(const LabelImage * labels, const std::vector<Cell> & cells)
{
  std::unordered_map<Label, VertexId> vertices;
  for (std::size_t v = ExteriorVertex + 1; v < cells.size(); ++v)
  {
    vertices.emplace(cells[v].label, static_cast<VertexId>(v));
  }
  const auto index = itk::UnaryGeneratorImageFilter<LabelImage, CellImage>::New();
  index->SetInput(labels);
  index->SetFunctor([&vertices](const std::int32_t & label) {
    const auto found = vertices.find(label);
    return found == vertices.end() ? ExteriorVertex : found->second;
  });
  const auto                pad = itk::ConstantPadImageFilter<CellImage, CellImage>::New();
  const CellImage::SizeType border = { { 1, 1, 1 } };
  pad->SetInput(index->GetOutput());
  pad->SetPadBound(border);
  pad->SetConstant(ExteriorVertex);
  pad->Update();
  return pad->GetOutput();
}

LabelVolume
MakePeerVolume(const CellImage * image)
{
  const auto  region = image->GetBufferedRegion();
  LabelVolume volume;
  volume.vertices = VoxelVertices(image->GetBufferPointer(), image->GetBufferPointer() + region.GetNumberOfPixels());
  for (unsigned int i = 0; i < 3; ++i)
  {
    volume.size[i] = static_cast<std::int32_t>(region.GetSize(i));
    volume.steps[i] = { { 0.0, 0.0, 0.0 } };
    volume.steps[i][i] = image->GetSpacing()[i];
  }
  return volume;
}
} // namespace tissue
