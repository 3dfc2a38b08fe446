/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "SyntheticTestTissue.h"

#include "itkSyntheticTissueImageSource.h"

template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeSyntheticTestTissue()
{
  using ImageType = itk::Image<TPixel, 3>;
  const double spacing[] = { 0.5, 0.5, 1.0 };
  const auto   source = itk::SyntheticTissueImageSource<ImageType>::New();
  source->SetSize({ { 40, 40, 18 } });
  source->SetSpacing(spacing);
  source->SetNumberOfCells(40);
  source->SetMargin(2);
  source->SetSeed(3);
  source->Update();
  typename ImageType::Pointer image = source->GetOutput();
  image->DisconnectPipeline();
  return image;
}

template itk::Image<signed char, 3>::Pointer
MakeSyntheticTestTissue<signed char>();
template itk::Image<unsigned char, 3>::Pointer
MakeSyntheticTestTissue<unsigned char>();
template itk::Image<short, 3>::Pointer
MakeSyntheticTestTissue<short>();
template itk::Image<unsigned short, 3>::Pointer
MakeSyntheticTestTissue<unsigned short>();
template itk::Image<int, 3>::Pointer
MakeSyntheticTestTissue<int>();
template itk::Image<unsigned int, 3>::Pointer
MakeSyntheticTestTissue<unsigned int>();
template itk::Image<long long, 3>::Pointer
MakeSyntheticTestTissue<long long>();
template itk::Image<unsigned long long, 3>::Pointer
MakeSyntheticTestTissue<unsigned long long>();
