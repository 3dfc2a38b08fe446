/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/BlobSelection.h"

#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace tissue
{
namespace
{
/** Gives the share of the smaller ball's volume that is in the other ball. */
double
Overlap(double radius, double other, double distance)
{
  const double smaller = std::min(radius, other);
  const double larger = std::max(radius, other);
  if (distance >= smaller + larger)
  {
    return 0.0;
  }
  if (distance <= larger - smaller)
  {
    return 1.0;
  }
  // What the balls have in common is a lens of two spherical caps.
  const double sum = smaller + larger - distance;
  const double difference = larger - smaller;
  const double lens =
    sum * sum * (distance * distance + 2.0 * distance * (smaller + larger) - 3.0 * difference * difference);
  return lens / (16.0 * distance * smaller * smaller * smaller);
}
} // namespace

double
BlobRadius(double scale)
{
  return std::sqrt(3.0) * scale;
}

BlobScaleRange
ChooseBlobScales(std::vector<Blob> maxima)
{
  // The weighted median is the scale at which half of the sum of all weights is reached. The range goes from it by a
  // factor of two down and up.
  constexpr double factor = 2.0;
  std::sort(maxima.begin(), maxima.end(), [](const Blob & a, const Blob & b) {
    return std::tie(a.scale, a.response) < std::tie(b.scale, b.response);
  });
  const auto weight = [](const Blob & blob) { return blob.response * blob.response * std::pow(blob.scale, 3); };
  double     sum = 0.0;
  for (const Blob & blob : maxima)
  {
    sum += weight(blob);
  }
  double below = 0.0;
  for (const Blob & blob : maxima)
  {
    below += weight(blob);
    if (below >= 0.5 * sum)
    {
      return { blob.scale / factor, blob.scale * factor };
    }
  }
  return {};
}

double
ChooseBlobThreshold(std::vector<double> responses)
{
  // Otsu's method on the sorted logarithms, without a histogram: of all cuts into the first k and the other n - k the
  // one of the greatest variance between the two, k (n - k) times the squared difference of their means. The threshold
  // is halfway between the two responses at the cut, in logarithms.
  // Responses weaker than a hundredth of the greatest would draw the cut into the noise, so they are left out. Means
  // closer than a factor of 3 are those of a single kind, which is not to be cut in two.
  constexpr double leastShare = 0.01;
  constexpr double leastFactor = 3.0;
  std::sort(responses.begin(), responses.end());
  responses.erase(
    responses.begin(),
    std::lower_bound(responses.begin(), responses.end(), responses.empty() ? 0.0 : leastShare * responses.back()));
  if (responses.size() < 2)
  {
    return 0.0;
  }
  const double least = responses.front();
  double       sum = 0.0;
  for (double & response : responses)
  {
    response = std::log(response);
    sum += response;
  }
  const auto  n = static_cast<double>(responses.size());
  double      below = 0.0;
  double      best = -1.0;
  double      factor = 0.0;
  std::size_t first = 0;
  for (std::size_t i = 1; i < responses.size(); ++i)
  {
    below += responses[i - 1];
    const auto   k = static_cast<double>(i);
    const double difference = below / k - (sum - below) / (n - k);
    const double between = k * (n - k) * difference * difference;
    if (between > best)
    {
      best = between;
      first = i;
      factor = std::exp(-difference);
    }
  }
  return factor < leastFactor ? least : std::exp(0.5 * (responses[first - 1] + responses[first]));
}

std::vector<Blob>
RemoveOverlappingBlobs(std::vector<Blob> blobs, double maximumOverlap)
{
  std::sort(blobs.begin(), blobs.end(), [](const Blob & a, const Blob & b) {
    return std::tie(b.response, a.position) < std::tie(a.response, b.position);
  });
  double largest = 0.0;
  for (const Blob & blob : blobs)
  {
    largest = std::max(largest, BlobRadius(blob.scale));
  }
  // The strongest blobs are kept first, so that each blob is compared with kept ones only. Balls that overlap have
  // their centres in the same box of this side, or in two boxes that touch.
  const double                                             side = std::max(2.0 * largest, 1e-300);
  std::map<std::array<std::int64_t, 3>, std::vector<Blob>> boxes;
  std::vector<Blob>                                        kept;
  for (const Blob & blob : blobs)
  {
    std::array<std::int64_t, 3> box;
    std::transform(blob.position.begin(), blob.position.end(), box.begin(), [side](double x) {
      return static_cast<std::int64_t>(std::floor(x / side));
    });
    bool isFree = true;
    for (int i = 0; i < 27 && isFree; ++i)
    {
      const auto at = boxes.find({ { box[0] + i % 3 - 1, box[1] + i / 3 % 3 - 1, box[2] + i / 9 - 1 } });
      isFree =
        at == boxes.end() || std::none_of(at->second.begin(), at->second.end(), [&](const Blob & other) {
          return Overlap(BlobRadius(blob.scale), BlobRadius(other.scale), Distance(blob.position, other.position)) >
                 maximumOverlap;
        });
    }
    if (isFree)
    {
      boxes[box].push_back(blob);
      kept.push_back(blob);
    }
  }
  return kept;
}
} // namespace tissue
