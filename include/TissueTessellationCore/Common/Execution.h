/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Execution_h
#define TissueTessellationCore_Execution_h

#include <cstddef>
#include <functional>
#include <stdexcept>

namespace tissue
{
/** Thrown where the progress function of an Execution asked to stop. */
class Aborted : public std::runtime_error
{
public:
  Aborted()
    : std::runtime_error("aborted on request")
  {}
};

/** \brief How a computation runs: who does its loops, who is told how far it is, and who may stop it.
 *
 * The core has no threads: who has some passes them in. A default-constructed object runs loops one after the other and
 * tells nobody. It is the last argument of all that may take long, and cheap to copy. What a computation yields does
 * not depend on it. */
class Execution
{
public:
  using LoopBody = std::function<void(std::size_t)>;
  /** Calls the body with 0 ... count - 1, each once, in any order and from any thread; returns when all are done. */
  using ParallelLoop = std::function<void(std::size_t count, const LoopBody & body)>;
  /** Told the fraction of the whole that is done, in 0 .. 1, ascending; returns false to stop. */
  using ProgressFunction = std::function<bool(double)>;

  Execution() = default;

  /** Either may be empty. */
  explicit Execution(ParallelLoop loop, ProgressFunction progress = {})
    : m_Loop(std::move(loop))
    , m_Progress(std::move(progress))
  {}

  /** Runs the body for 0 ... count - 1. The body may not depend on their order. */
  void
  For(std::size_t count, const LoopBody & body) const
  {
    if (m_Loop)
    {
      m_Loop(count, body);
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      body(i);
    }
  }

  /** Tells the fraction that is done; not from within a loop's body.
   * \throws Aborted where the progress function returns false. */
  void
  Report(double fraction) const
  {
    if (m_Progress && !m_Progress(fraction))
    {
      throw Aborted();
    }
  }

  /** The same for a part of the computation, whose 0 .. 1 is begin .. end of the whole. */
  Execution
  Part(double begin, double end) const
  {
    if (!m_Progress)
    {
      return *this;
    }
    return Execution(m_Loop, [progress = m_Progress, begin, end](double fraction) {
      return progress(begin + (end - begin) * fraction);
    });
  }

private:
  ParallelLoop     m_Loop;
  ProgressFunction m_Progress;
};
} // namespace tissue

#endif
