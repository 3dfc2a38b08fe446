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
  /** The standard deviation that the response would have of the image's noise alone; 0 where there is none. */
  double noise = 0.0;
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
 * The range goes from half to twice the median scale, and half a level of four an octave beyond. Each maximum counts by
 * response^2 scale^3, which is what it explains of the image's variance. The variance of noise falls by the third power
 * of the scale. Both ends are 0 where there is no maximum. */
BlobScaleRange
ChooseBlobScales(std::vector<Blob> maxima);

/** \brief Chooses the response that parts blobs from noise, from the responses of all maxima, most of which may be
 * noise.
 *
 * This is Otsu's threshold (N. Otsu 1979, doi:10.1109/TSMC.1979.4310076) of the logarithms of those responses that are
 * above a hundredth of the greatest: the two kinds differ by a factor, whatever the units of the image. There is one
 * kind only, and the threshold is the least of these responses, where the means of the two are less than a factor of 3
 * apart, or the variance between the two is less than `leastBetween` of the whole, 0 .. 1. It is 0 where there is no
 * response. */
double
ChooseBlobThreshold(std::vector<double> responses, double leastBetween = 0.0);

/** \brief Chooses the response that parts blobs from weaker ones that are no noise, either.
 *
 * It is the threshold of the certain ones, whose response noise does not have, where 0.85 of the variance is between
 * the two kinds. Evenly spread logarithms, such as those of nuclei that fade with depth, have 0.75, and are not cut in
 * two. If the threshold of all maxima is higher, it rules where it leaves out no more than a fifth of what it keeps:
 * the few ones between noise and blobs are no blobs, but many of them are. */
double
ChooseBlobThreshold(const std::vector<Blob> & certain, const std::vector<Blob> & all);

/** \brief Drops the blob of the weaker response of every two whose balls have more than `maximumOverlap`, 0 .. 1, of
 * the smaller one's volume in common. The others come by falling response, those of equal response by position. */
std::vector<Blob>
RemoveOverlappingBlobs(std::vector<Blob> blobs, double maximumOverlap);

/** \brief Finds blobs of another size than most, among the maxima of scales up to twice beyond the range of most.
 *
 * They count where they are of one size, smaller or larger: three or more, three quarters of which are within a factor
 * of 1.25 of their median scale, have a quarter or more of the others' median response. The texture and the fragments
 * of blobs are of many sizes. A smaller one that has more than a tenth of its ball in common with one of `blobs`, and a
 * larger one that a stronger of them overlaps by more than `maximumOverlap`, is left out.
 * \param blobs those within the range, of which two do not overlap. The result is in no special order. */
std::vector<Blob>
FindBlobsOfOtherSizes(const std::vector<Blob> & maxima, const std::vector<Blob> & blobs, const BlobScaleRange & range,
                      double maximumOverlap);

/** \brief Drops blobs that have less than a tenth of the median response of those around them.
 *
 * These are within boxes of six median radii and the boxes that touch them; fewer than five others tell nothing. Where
 * blobs fade with depth, those around fade as well. */
std::vector<Blob>
RemoveOutshoneBlobs(std::vector<Blob> blobs);

/** \brief Tells whether blobs are no stronger than those of the inverse image, as it is with noise, be it independent
 * from voxel to voxel or not: whether the mean response of the strongest quarter is less than 1.25 times that of as
 * many of the inverse. Of balls that touch each other it is 1.5 times, of nuclei with space between 3 times or more. */
bool
AreBlobsWeak(const std::vector<Blob> & blobs, const std::vector<Blob> & inverse);
} // namespace tissue

#endif
