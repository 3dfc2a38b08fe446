/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SyntheticTestTissue_h
#define SyntheticTestTissue_h

#include "itkSyntheticTissueImageSource.h"

/** A dome of 40 anisotropic cells, labels 1 to 40 in exterior 0, of voxels of 0.5 x 0.5 x 1. */
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

#endif
