/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_BlobSelection_h
#define TissueTessellationCore_BlobSelection_h

#include "TissueTessellationCore/Common/Types.h"

#include <vector>

namespace tissue
{
/** A maximum of the scale space of an image. */
struct Blob
{
  Point position;
  /** The standard deviation of the Gaussian that fits best, in the units of the position. A ball answers at its radius
   * over the square root of 3. */
  double scale;
  /** The normalized difference of Gaussians, which is positive. */
  double response;
};

/** The radius of the ball that answers at a scale. */
double
BlobRadius(double scale);

/** The scales of the smallest and the largest blobs. */
struct BlobScaleRange
{
  double minimum = 0.0;
  double maximum = 0.0;
};

/** \brief Chooses the range of the scales of the blobs that an image is made of, from all maxima of its scale space.
 * Most of these may be noise, the texture of the blobs, or groups of them.
 *
 * The range goes from half to twice the median scale, where each maximum counts by response^2 scale^3, which is what it
 * explains of the image's variance. The variance of noise falls by the third power of the scale. Both ends are 0 where
 * there is no maximum. */
BlobScaleRange
ChooseBlobScales(std::vector<Blob> maxima);

/** \brief Chooses the response that parts blobs from noise, from the responses of all maxima, most of which may be
 * noise.
 *
 * This is Otsu's threshold (N. Otsu 1979, doi:10.1109/TSMC.1979.4310076) of the logarithms of those responses that are
 * above a hundredth of the greatest: the two kinds differ by a factor, whatever the units of the image. Where the means
 * of the two are less than a factor of 3 apart there is one kind only, and the threshold is the least response. It is 0
 * for fewer than two responses. */
double
ChooseBlobThreshold(std::vector<double> responses);

/** \brief Drops the blob of the weaker response of every two whose balls have more than `maximumOverlap`, 0 .. 1, of
 * the smaller one's volume in common. The others come by falling response, those of equal response by position. */
std::vector<Blob>
RemoveOverlappingBlobs(std::vector<Blob> blobs, double maximumOverlap);
} // namespace tissue

#endif
