/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Random_h
#define TissueTessellationCore_Random_h

#include <cstdint>
#include <random>

namespace tissue
{
/** \brief A seeded stream of random numbers that is the same on every platform.
 *
 * The standard library's engines give the same numbers everywhere, but its distributions do not. */
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : m_Engine(seed)
  {}

  /** Returns a number that is uniform in [0, 1): the engine's upper 53 bits, as many as a double keeps, over 2^53. */
  double
  Uniform()
  {
    return static_cast<double>(m_Engine() >> 11) * (1.0 / 9007199254740992.0);
  }

  /** Returns an index that is uniform in 0 .. bound - 1, up to a bias below bound / 2^53. `bound` must be above 0. */
  std::size_t
  Index(std::size_t bound)
  {
    return static_cast<std::size_t>(Uniform() * static_cast<double>(bound));
  }

private:
  std::mt19937_64 m_Engine;
};
} // namespace tissue

#endif
