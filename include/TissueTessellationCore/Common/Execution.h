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
/** The exception that is thrown when the progress function of an Execution has asked to stop. */
class Aborted : public std::runtime_error
{
public:
  Aborted()
    : std::runtime_error("aborted on request")
  {}
};

/** \brief How a computation runs: who does its loops, who is told how far it is, and who may stop it.
 *
 * The core has no threads of its own: a caller that has some passes them in. A default-constructed object runs loops in
 * the calling thread and tells nobody. An Execution is the last argument of every function that may take long, and is
 * cheap to copy. The result of a computation does not depend on it. */
class Execution
{
public:
  using LoopBody = std::function<void(std::size_t)>;
  /** A loop calls the body once with each of 0 ... count - 1, in any order and from any thread, and returns when all
   * calls are done. */
  using ParallelLoop = std::function<void(std::size_t count, const LoopBody & body)>;
  /** The function is told the fraction of the whole that is done, in 0 .. 1, ascending, and returns false to stop. */
  using ProgressFunction = std::function<bool(double)>;
  /** The function is told what is being done from now on, in a few words. */
  using PhaseFunction = std::function<void(const char *)>;

  Execution() = default;

  /** Each function may be empty. */
  explicit Execution(ParallelLoop loop, ProgressFunction progress = {}, PhaseFunction phase = {})
    : m_Loop(std::move(loop))
    , m_Progress(std::move(progress))
    , m_Phase(std::move(phase))
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

  /** Tells the progress function which fraction is done. It must not be called from within a loop's body.
   * \throws Aborted where the progress function returns false. */
  void
  Report(double fraction) const
  {
    if (m_Progress && !m_Progress(fraction))
    {
      throw Aborted();
    }
  }

  /** Tells what is being done from now on: "Fitting the walls". As Report(), not from within a loop's body. */
  void
  EnterPhase(const char * phase) const
  {
    if (m_Phase)
    {
      m_Phase(phase);
    }
  }

  /** Returns the execution of a part of the computation, whose 0 .. 1 is begin .. end of the whole. */
  Execution
  Part(double begin, double end) const
  {
    if (!m_Progress)
    {
      return *this;
    }
    return Execution(
      m_Loop,
      [progress = m_Progress, begin, end](double fraction) { return progress(begin + (end - begin) * fraction); },
      m_Phase);
  }

private:
  ParallelLoop     m_Loop;
  ProgressFunction m_Progress;
  PhaseFunction    m_Phase;
};
} // namespace tissue

#endif
