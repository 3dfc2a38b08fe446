/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_BlobNoise_h
#define TissueTessellationCore_BlobNoise_h

#include <array>

namespace tissue
{
/** \brief The standard deviation of the normalized difference of Gaussians of an image of noise, independent from voxel
 * to voxel and of deviation 1.
 *
 * The Gaussians' deviations are the scale over and times the root of `step`, the difference is over the logarithm of
 * `step`; `spacing` is the size of a voxel in the units of the scale. It falls by about scale^-1.5. */
double
NoiseResponse(double scale, double step, const std::array<double, 3> & spacing);

/** \brief The standard deviation of an image of noise, independent from voxel to voxel and of deviation 1, after it was
 * smoothed by a Gaussian. \param scale its standard deviation, in the units of `spacing`, the size of a voxel. */
double
SmoothedNoise(double scale, const std::array<double, 3> & spacing);

/** \brief How many times greater the deviation of noise smoothed by a Gaussian is near one side of the image than far
 * inside.
 *
 * Beyond the border the image goes on as it is on it, so that a single voxel counts as many. \param distance from the
 * centre of the outermost voxel, \param scale of the Gaussian, both in voxels. */
double
BorderNoise(double distance, double scale);

/** \brief How many deviations of its noise the response of a blob must have, so that noise alone makes less than about
 * one in ten images have a blob: sqrt(2 ln n) + 0.7, about where the greatest of n normal variables is, and a little.
 * \param places how many balls of the blob's size there is room for in the image; at least 1. */
double
LeastBlobEvidence(double places);
} // namespace tissue

#endif
