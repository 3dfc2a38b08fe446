/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Points/BlobSelection.h"

#include "Common/Algorithms.h"
#include "TissueTessellationCore/Geometry/Vector.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
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

double
Overlap(const Blob & a, const Blob & b)
{
  return Overlap(BlobRadius(a.scale), BlobRadius(b.scale), Distance(a.position, b.position));
}

/** Blobs by their places. Those nearer than a side are in the same box, or in two boxes that touch. */
class BlobBoxes
{
public:
  explicit BlobBoxes(double side)
    : m_Side(std::max(side, 1e-300))
  {}

  void
  Add(const Blob & blob)
  {
    m_Boxes[this->BoxOf(blob)].push_back(blob);
  }

  /** Tells whether a condition holds of any blob in the same box or those that touch it. It is tried up to the first.
   */
  template <typename TCondition>
  bool
  AnyNear(const Blob & blob, const TCondition & condition) const
  {
    const Box box = this->BoxOf(blob);
    for (int i = 0; i < 27; ++i)
    {
      const auto at = m_Boxes.find({ { box[0] + i % 3 - 1, box[1] + i / 3 % 3 - 1, box[2] + i / 9 - 1 } });
      if (at != m_Boxes.end() && std::any_of(at->second.begin(), at->second.end(), condition))
      {
        return true;
      }
    }
    return false;
  }

private:
  using Box = std::array<std::int64_t, 3>;

  Box
  BoxOf(const Blob & blob) const
  {
    Box box;
    std::transform(blob.position.begin(), blob.position.end(), box.begin(), [this](double x) {
      return static_cast<std::int64_t>(std::floor(x / m_Side));
    });
    return box;
  }

  double                           m_Side;
  std::map<Box, std::vector<Blob>> m_Boxes;
};

/** Balls that are farther apart do not overlap. */
double
LargestDiameter(const std::vector<Blob> & blobs)
{
  double largest = 0.0;
  for (const Blob & blob : blobs)
  {
    largest = std::max(largest, 2.0 * BlobRadius(blob.scale));
  }
  return largest;
}

/** The middle of the values of all blobs; there must be one. */
template <typename TValue>
double
MedianOf(const std::vector<Blob> & blobs, const TValue & value)
{
  std::vector<double> values(blobs.size());
  std::transform(blobs.begin(), blobs.end(), values.begin(), value);
  return Median(std::move(values));
}

/** Those of the median's size, if most are of it; else none. */
std::vector<Blob>
TakeOneSize(std::vector<Blob> blobs)
{
  constexpr std::size_t fewest = 3;
  constexpr double      leastShare = 0.75;
  constexpr double      factor = 1.25;
  const auto            number = blobs.size();
  if (number >= fewest)
  {
    const double median = MedianOf(blobs, [](const Blob & blob) { return blob.scale; });
    const auto   isOther = [median](const Blob & blob) {
      return blob.scale < median / factor || blob.scale > median * factor;
    };
    blobs.erase(std::remove_if(blobs.begin(), blobs.end(), isOther), blobs.end());
  }
  const bool areMost = static_cast<double>(blobs.size()) >= leastShare * static_cast<double>(number);
  return blobs.size() >= fewest && areMost ? blobs : std::vector<Blob>();
}

std::vector<double>
ResponsesOf(const std::vector<Blob> & blobs)
{
  std::vector<double> responses(blobs.size());
  std::transform(blobs.begin(), blobs.end(), responses.begin(), [](const Blob & blob) { return blob.response; });
  return responses;
}

/** The mean response of the strongest so many blobs, or of all. */
double
MeanOfStrongest(const std::vector<Blob> & blobs, std::size_t number)
{
  std::vector<double> responses = ResponsesOf(blobs);
  std::sort(responses.begin(), responses.end(), std::greater<double>());
  responses.resize(std::min(number, responses.size()));
  return responses.empty()
           ? 0.0
           : std::accumulate(responses.begin(), responses.end(), 0.0) / static_cast<double>(responses.size());
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
  // factor of 2^(1 + 1/8) down and up.
  constexpr double factor = 2.18;
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
ChooseBlobThreshold(std::vector<double> responses, double leastBetween)
{
  // Otsu's method on the sorted logarithms, without a histogram: of all cuts into the first k and the other n - k the
  // one of the greatest variance between the two, k (n - k) times the squared difference of their means. The threshold
  // is halfway between the two responses at the cut, in logarithms.
  // Responses weaker than a hundredth of the greatest would draw the cut into the noise, so they are left out.
  constexpr double leastShare = 0.01;
  constexpr double leastFactor = 3.0;
  std::sort(responses.begin(), responses.end());
  responses.erase(
    responses.begin(),
    std::lower_bound(responses.begin(), responses.end(), responses.empty() ? 0.0 : leastShare * responses.back()));
  if (responses.size() < 2)
  {
    return responses.empty() ? 0.0 : responses.front();
  }
  const double least = responses.front();
  double       sum = 0.0;
  double       squares = 0.0;
  for (double & response : responses)
  {
    response = std::log(response / least);
    sum += response;
    squares += response * response;
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
  const bool isOneKind = factor < leastFactor || best < leastBetween * (n * squares - sum * sum);
  return isOneKind ? least : least * std::exp(0.5 * (responses[first - 1] + responses[first]));
}

double
ChooseBlobThreshold(const std::vector<Blob> & certain, const std::vector<Blob> & all)
{
  constexpr double leastBetween = 0.85;
  constexpr double mostLeftOut = 0.2;
  const double     least = ChooseBlobThreshold(ResponsesOf(certain), leastBetween);
  const double     higher = ChooseBlobThreshold(ResponsesOf(all));
  const auto       numberFrom = [&certain](double threshold) {
    const auto isStrong = [threshold](const Blob & blob) { return blob.response >= threshold; };
    return static_cast<double>(std::count_if(certain.begin(), certain.end(), isStrong));
  };
  const bool areFew = numberFrom(least) <= (1.0 + mostLeftOut) * numberFrom(higher);
  return areFew ? std::max(least, higher) : least;
}

std::vector<Blob>
RemoveOverlappingBlobs(std::vector<Blob> blobs, double maximumOverlap)
{
  std::sort(blobs.begin(), blobs.end(), [](const Blob & a, const Blob & b) {
    return std::tie(b.response, a.position) < std::tie(a.response, b.position);
  });
  // The strongest blobs are kept first, so that each blob is compared with kept ones only.
  BlobBoxes         boxes(LargestDiameter(blobs));
  std::vector<Blob> kept;
  for (const Blob & blob : blobs)
  {
    if (!boxes.AnyNear(blob, [&](const Blob & other) { return Overlap(blob, other) > maximumOverlap; }))
    {
      boxes.Add(blob);
      kept.push_back(blob);
    }
  }
  return kept;
}

std::vector<Blob>
FindBlobsOfOtherSizes(const std::vector<Blob> & maxima, const std::vector<Blob> & blobs, const BlobScaleRange & range,
                      double maximumOverlap)
{
  constexpr double  farthest = 2.0;
  constexpr double  leastResponse = 0.25;
  constexpr double  mostOfSmall = 0.1;
  std::vector<Blob> smaller;
  std::vector<Blob> larger;
  if (blobs.empty())
  {
    return {};
  }
  const double least = leastResponse * MedianOf(blobs, [](const Blob & blob) { return blob.response; });
  BlobBoxes    boxes(std::max(LargestDiameter(maxima), LargestDiameter(blobs)));
  for (const Blob & blob : blobs)
  {
    boxes.Add(blob);
  }
  for (const Blob & blob : maxima)
  {
    const bool isSmaller = blob.scale < range.minimum && blob.scale >= range.minimum / farthest;
    const bool isLarger = blob.scale > range.maximum && blob.scale <= range.maximum * farthest;
    if (blob.response < least || (!isSmaller && !isLarger))
    {
      continue;
    }
    const bool isTaken = boxes.AnyNear(blob, [&](const Blob & other) {
      return isSmaller ? Overlap(blob, other) > mostOfSmall
                       : other.response >= blob.response && Overlap(blob, other) > maximumOverlap;
    });
    if (!isTaken)
    {
      (isSmaller ? smaller : larger).push_back(blob);
    }
  }
  std::vector<Blob>       found = TakeOneSize(RemoveOverlappingBlobs(std::move(smaller), maximumOverlap));
  const std::vector<Blob> large = TakeOneSize(RemoveOverlappingBlobs(std::move(larger), maximumOverlap));
  found.insert(found.end(), large.begin(), large.end());
  return found;
}

std::vector<Blob>
RemoveOutshoneBlobs(std::vector<Blob> blobs)
{
  constexpr double      side = 6.0;
  constexpr double      leastShare = 0.1;
  constexpr std::size_t fewest = 5;
  if (blobs.empty())
  {
    return blobs;
  }
  BlobBoxes boxes(side * MedianOf(blobs, [](const Blob & blob) { return BlobRadius(blob.scale); }));
  for (const Blob & blob : blobs)
  {
    boxes.Add(blob);
  }
  const auto isOutshone = [&boxes](const Blob & blob) {
    std::vector<Blob> around;
    boxes.AnyNear(blob, [&around](const Blob & other) {
      around.push_back(other);
      return false;
    });
    const auto response = [](const Blob & other) { return other.response; };
    return around.size() > fewest && blob.response < leastShare * MedianOf(around, response);
  };
  blobs.erase(std::remove_if(blobs.begin(), blobs.end(), isOutshone), blobs.end());
  return blobs;
}

bool
AreBlobsWeak(const std::vector<Blob> & blobs, const std::vector<Blob> & inverse)
{
  constexpr double      leastFactor = 1.25;
  constexpr std::size_t fewest = 3;
  const std::size_t     number = std::max(fewest, blobs.size() / 4);
  return MeanOfStrongest(blobs, number) < leastFactor * MeanOfStrongest(inverse, number);
}
} // namespace tissue
