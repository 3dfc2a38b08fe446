/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MembraneImage_h
#define MembraneImage_h

#include "LabelImageTestHelpers.h"

#include <itkImageRegionConstIterator.h>

namespace tissue_test
{
/** An image of the membranes of a label image, with its place in space: 200 in the voxels beside another label, less in
 * the cells than that by more than the noise is, and dark in the exterior, label 0. */
template <typename TPixel, typename TLabelImage>
typename itk::Image<TPixel, 3>::Pointer
MakeMembraneImage(const TLabelImage * labels, unsigned int noise = 20)
{
  std::mt19937 random(7);
  const auto   region = labels->GetLargestPossibleRegion();
  const auto   image = itk::Image<TPixel, 3>::New();
  image->CopyInformation(labels);
  image->SetRegions(region);
  image->Allocate();
  for (itk::ImageRegionIteratorWithIndex<itk::Image<TPixel, 3>> it(image, region); !it.IsAtEnd(); ++it)
  {
    const auto own = labels->GetPixel(it.GetIndex());
    bool       isMembrane = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const int step : { -1, 1 })
      {
        auto beside = it.GetIndex();
        beside[axis] += step;
        isMembrane = isMembrane || (own != 0 && region.IsInside(beside) && labels->GetPixel(beside) != own);
      }
    }
    it.Set(static_cast<TPixel>((isMembrane ? 200 : own != 0 ? 40 : 5) + random() % (noise + 1)));
  }
  return image;
}

/** Share of the voxels with the same label in both images. */
template <typename TImage>
double
Agreement(const TImage * a, const TImage * b)
{
  double                                numberOfEqual = 0.0;
  const auto                            region = a->GetLargestPossibleRegion();
  itk::ImageRegionConstIterator<TImage> itB(b, region);
  for (itk::ImageRegionConstIterator<TImage> it(a, region); !it.IsAtEnd(); ++it, ++itB)
  {
    numberOfEqual += it.Get() == itB.Get() ? 1.0 : 0.0;
  }
  return numberOfEqual / static_cast<double>(region.GetNumberOfPixels());
}
} // namespace tissue_test

#endif
