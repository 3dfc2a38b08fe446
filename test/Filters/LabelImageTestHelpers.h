/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef LabelImageTestHelpers_h
#define LabelImageTestHelpers_h

#include "itkImage.h"
#include "itkImageRegionIteratorWithIndex.h"
#include "itkLabelJunctionExtractionFilter.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

/** Label images made in code, for the tests of the filters. */
namespace tissue_test
{
template <typename TPixel>
using LabelImage = itk::Image<TPixel, 3>;

/** An image whose voxel (x, y, z) is labelOf(x, y, z); its region starts at the index given. */
template <typename TPixel, typename TFunction>
typename LabelImage<TPixel>::Pointer
MakeImage(const itk::Size<3> & size, TFunction labelOf, const itk::Index<3> & start = { { 0, 0, 0 } })
{
  const auto image = LabelImage<TPixel>::New();
  image->SetRegions(itk::ImageRegion<3>(start, size));
  image->Allocate();
  itk::ImageRegionIteratorWithIndex<LabelImage<TPixel>> it(image, image->GetLargestPossibleRegion());
  for (; !it.IsAtEnd(); ++it)
  {
    const auto index = it.GetIndex() - start;
    it.Set(static_cast<TPixel>(labelOf(index[0], index[1], index[2])));
  }
  return image;
}

/** Four cells, labels 10, 20, 30 and 40, of 4x4x4 voxels each in a square around the line x = y = 5.5, in a margin of
 * two voxels of the exterior label. */
template <typename TPixel>
typename LabelImage<TPixel>::Pointer
MakeFourCubes(int exterior = 0, const itk::Index<3> & start = { { 0, 0, 0 } })
{
  return MakeImage<TPixel>(
    { { 12, 12, 8 } },
    [exterior](long x, long y, long z) {
      const bool isInside = x >= 2 && x < 10 && y >= 2 && y < 10 && z >= 2 && z < 6;
      return isInside ? 10 + 10 * (x >= 6) + 20 * (y >= 6) : exterior;
    },
    start);
}

/** Labels 1 ... count drawn at random, voxel by voxel. */
template <typename TPixel>
typename LabelImage<TPixel>::Pointer
MakeNoise(const itk::Size<3> & size, int count, unsigned int seed)
{
  std::mt19937 random(seed);
  return MakeImage<TPixel>(size, [&](long, long, long) { return 1 + random() % count; });
}

/** A tissue of about 5 cells an axis in a ball: the cells of the nearest points of a jittered grid; exterior 0. */
template <typename TPixel>
typename LabelImage<TPixel>::Pointer
MakeBallTissue(long size, unsigned int seed)
{
  constexpr long                     pointsPerAxis = 5;
  std::mt19937                       random(seed);
  std::vector<std::array<double, 3>> points;
  const double                       step = static_cast<double>(size) / pointsPerAxis;
  for (long i = 0; i < pointsPerAxis * pointsPerAxis * pointsPerAxis; ++i)
  {
    std::array<double, 3> point = { { double(i % 5), double(i / 5 % 5), double(i / 25) } };
    for (double & coordinate : point)
    {
      coordinate = (coordinate + 0.2 + 0.6 * static_cast<double>(random() % 1000) / 1000.0) * step;
    }
    points.push_back(point);
  }
  const auto sideSize = static_cast<itk::SizeValueType>(size);
  return MakeImage<TPixel>({ { sideSize, sideSize, sideSize } }, [&](long x, long y, long z) {
    const auto squaredDistance = [&](const std::array<double, 3> & p) {
      return (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y) + (p[2] - z) * (p[2] - z);
    };
    const double middle = 0.5 * static_cast<double>(size - 1);
    if (squaredDistance({ { middle, middle, middle } }) > 0.2 * static_cast<double>(size * size))
    {
      return 0L;
    }
    const auto nearest = std::min_element(points.begin(), points.end(), [&](const auto & a, const auto & b) {
      return squaredDistance(a) < squaredDistance(b);
    });
    return 1L + (nearest - points.begin());
  });
}

/** The junctions of an image under the filter's defaults. */
template <typename TImage>
tissue::JunctionSet
Extract(const TImage * image)
{
  const auto filter = itk::LabelJunctionExtractionFilter<TImage>::New();
  filter->SetInput(image);
  filter->Update();
  return filter->GetOutput()->GetJunctionSet();
}
} // namespace tissue_test

#endif
