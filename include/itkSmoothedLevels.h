/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkSmoothedLevels_h
#define itkSmoothedLevels_h

#include "itkCastImageFilter.h"
#include "itkDiscreteGaussianImageFilter.h"
#include "itkImage.h"
#include "itkImageRegionConstIteratorWithIndex.h"
#include "itkRescaleIntensityImageFilter.h"
#include "itkShiftScaleImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace itk
{
/** The images that are flooded. Their levels, in the order of the intensities, are as many as are worth telling apart.
 */
using LevelImageType = Image<std::uint16_t, 3>;

/** Throws ExceptionObject, with the place, where the image holds a pixel that is not a finite number, and where all its
 * pixels are the same. */
template <typename TImage>
void
RequireVaryingFinitePixels(const TImage * image)
{
  ImageRegionConstIteratorWithIndex<TImage> it(image, image->GetLargestPossibleRegion());
  const auto                                first = it.Get();
  bool                                      isVarying = false;
  for (; !it.IsAtEnd(); ++it)
  {
    if (!std::isfinite(static_cast<double>(it.Get())))
    {
      itkGenericExceptionMacro(<< "The pixel at index " << it.GetIndex() << " is " << it.Get()
                               << ", must be a finite number");
    }
    isVarying = isVarying || it.Get() != first;
  }
  if (!isVarying)
  {
    itkGenericExceptionMacro(<< "All pixels of the image are " << +first << ": it shows nothing");
  }
}

/** An image of levels, and how many of them are as much as 1 in the image that it was made of. */
struct SmoothedLevels
{
  LevelImageType::Pointer image;
  double                  levelsPerUnit;
};

/** Smooths the image by a Gaussian of standard deviation `sigma` in physical units, the same along all axes whatever
 * the voxels' size (not at all where it is 0), and spreads it over the levels from 0 to 65535. Images of 8 and 16 bits
 * that are not smoothed lose nothing. With `isInverse` the darkest pixels are the highest levels. */
template <typename TImage>
SmoothedLevels
MakeSmoothedLevels(const TImage * image, double sigma, bool isInverse, ThreadIdType numberOfWorkUnits)
{
  using RealImageType = Image<float, 3>;
  const auto cast = CastImageFilter<TImage, RealImageType>::New();
  cast->SetInput(image);
  cast->SetNumberOfWorkUnits(numberOfWorkUnits);
  const auto turn = ShiftScaleImageFilter<RealImageType, RealImageType>::New();
  turn->SetInput(cast->GetOutput());
  turn->SetScale(-1.0);
  turn->SetNumberOfWorkUnits(numberOfWorkUnits);
  const RealImageType * real = isInverse ? turn->GetOutput() : cast->GetOutput();
  const auto            smooth = DiscreteGaussianImageFilter<RealImageType, RealImageType>::New();
  const auto            spacing = image->GetSpacing();
  const double          widest = 8.0 * sigma / *std::min_element(spacing.Begin(), spacing.End());
  smooth->SetInput(real);
  smooth->SetVariance(sigma * sigma);
  smooth->SetMaximumKernelWidth(static_cast<int>(std::min(widest, 1e4)) + 3);
  smooth->SetNumberOfWorkUnits(numberOfWorkUnits);
  const auto rescale = RescaleIntensityImageFilter<RealImageType, LevelImageType>::New();
  rescale->SetInput(sigma > 0.0 ? smooth->GetOutput() : real);
  rescale->SetNumberOfWorkUnits(numberOfWorkUnits);
  rescale->Update();
  return { rescale->GetOutput(), rescale->GetScale() };
}
} // namespace itk

#endif
