/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef itkTessellationBricks_h
#define itkTessellationBricks_h

#include "TissueTessellationCore/Tessellation/SyntheticCells.h"

#include <algorithm>
#include <cmath>

namespace itk
{
/** The functions between images and tessellations, which turn voxels into points, and bricks of voxels into the balls
 * by which seeds are looked up. */
namespace TessellationBricks
{
/** Cuts a region into bricks, the last ones smaller, and calls visit(brick). */
template <typename TRegion, typename TVisitor>
void
VisitBricks(const TRegion & region, const typename TRegion::SizeType & brickSize, const TVisitor & visit)
{
  const typename TRegion::IndexType first = region.GetIndex();
  const typename TRegion::IndexType last = region.GetUpperIndex();
  typename TRegion::IndexType       index;
  for (index[2] = first[2]; index[2] <= last[2]; index[2] += brickSize[2])
  {
    for (index[1] = first[1]; index[1] <= last[1]; index[1] += brickSize[1])
    {
      for (index[0] = first[0]; index[0] <= last[0]; index[0] += brickSize[0])
      {
        TRegion brick(index, brickSize);
        brick.Crop(region);
        visit(brick);
      }
    }
  }
}

/** Gives the place of a voxel along the image's own axes, in physical units from the image's first voxel. */
template <typename TImage>
tissue::Point
ToTissuePoint(const TImage * image, const typename TImage::IndexType & index)
{
  const typename TImage::IndexType start = image->GetLargestPossibleRegion().GetIndex();
  tissue::Point                    point;
  for (unsigned int i = 0; i < 3; ++i)
  {
    point[i] = static_cast<double>(index[i] - start[i]) * image->GetSpacing()[i];
  }
  return point;
}

/** Gives the ball about the centres of a region's voxels. */
template <typename TImage>
tissue::TissueSamples::Group
EnclosingBall(const TImage * image, const typename TImage::RegionType & region)
{
  const tissue::Point          lower = ToTissuePoint(image, region.GetIndex());
  const tissue::Point          upper = ToTissuePoint(image, region.GetUpperIndex());
  tissue::TissueSamples::Group ball;
  for (unsigned int i = 0; i < 3; ++i)
  {
    ball.center[i] = 0.5 * (lower[i] + upper[i]);
    ball.radius += (upper[i] - ball.center[i]) * (upper[i] - ball.center[i]);
  }
  ball.radius = std::sqrt(ball.radius);
  return ball;
}

/** Gives the number of voxels along each axis that make up a length in physical units, at least one. */
template <typename TImage>
typename TImage::SizeType
SizeOfLength(const TImage * image, double length)
{
  typename TImage::SizeType size;
  for (unsigned int i = 0; i < 3; ++i)
  {
    size[i] = std::max<SizeValueType>(1, static_cast<SizeValueType>(length / image->GetSpacing()[i]));
  }
  return size;
}

/** Samples the voxels that are to be cells, evenly: about 125 to a cell of the diameter, and 27 to a group.
 *
 * Bricks are three strides wide, a stride a fifth of the diameter. In each block of a stride the middle voxel is a
 * sample if it is not exterior; the samples of a brick make a group. */
template <typename TImage>
tissue::TissueSamples
SampleTissue(const TImage * image, typename TImage::PixelType exteriorLabel, double cellDiameter)
{
  using SizeType = typename TImage::SizeType;
  using IndexType = typename TImage::IndexType;
  using RegionType = typename TImage::RegionType;
  tissue::TissueSamples samples;
  const SizeType        stride = SizeOfLength(image, cellDiameter / 5.0);
  SizeType              brickSize;
  for (unsigned int i = 0; i < 3; ++i)
  {
    brickSize[i] = 3 * stride[i];
    samples.boxSize[i] = static_cast<double>(stride[i]) * image->GetSpacing()[i];
  }
  const RegionType region = image->GetRequestedRegion();
  VisitBricks(region, brickSize, [&](const RegionType & brick) {
    VisitBricks(brick, stride, [&](const RegionType & block) {
      IndexType middle;
      for (unsigned int i = 0; i < 3; ++i)
      {
        middle[i] = block.GetIndex(i) + static_cast<IndexValueType>(block.GetSize(i) / 2);
      }
      if (image->GetPixel(middle) != exteriorLabel)
      {
        samples.points.push_back(ToTissuePoint(image, middle));
      }
    });
    const std::size_t end = samples.groups.empty() ? 0 : samples.groups.back().end;
    if (samples.points.size() > end)
    {
      samples.groups.push_back(EnclosingBall(image, brick));
      samples.groups.back().end = samples.points.size();
    }
  });
  return samples;
}
} // namespace TessellationBricks
} // namespace itk

#endif
