/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SyntheticTissueTestHelpers_h
#define SyntheticTissueTestHelpers_h

#include "itkSyntheticTissueImageSource.h"

#include <vector>

namespace tissue_test
{
using Shape = itk::SyntheticTissueEnums::Shape;
using CellModel = itk::SyntheticTissueEnums::CellModel;
using ImageType = itk::Image<unsigned short, 3>;
using SourceType = itk::SyntheticTissueImageSource<ImageType>;

constexpr unsigned int SmallNumberOfCells = 60;

/** Of about 700 voxels a cell. */
inline SourceType::Pointer
MakeSmallSource(Shape shape, CellModel model)
{
  auto source = SourceType::New();
  source->SetSize(ImageType::SizeType{ { 48, 44, 40 } });
  source->SetNumberOfCells(SmallNumberOfCells);
  source->SetShape(shape);
  source->SetCellModel(model);
  return source;
}

template <typename TImage>
std::vector<typename TImage::PixelType>
VoxelsOf(itk::ImageSource<TImage> * source)
{
  source->Update();
  const TImage * image = source->GetOutput();
  return { image->GetBufferPointer(),
           image->GetBufferPointer() + image->GetLargestPossibleRegion().GetNumberOfPixels() };
}
} // namespace tissue_test

#endif
