/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/CommandLine/SignalWatch.h"

#include "Shared/Files/TemporaryFiles.h"

#include <csignal>
#include <system_error>
#include <thread>

namespace tissue
{
namespace
{
bool
IsIgnored(int signal)
{
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t
FindEndingSignals()
{
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU })
  {
    if (!IsIgnored(signal))
    {
      sigaddset(&signals, signal);
    }
  }
  return signals;
}

/** Waits for one of the signals, which are blocked, and ends the program by it. */
void
WaitForSignal(const sigset_t & signals)
{
  int received = 0;
  if (sigwait(&signals, &received) != 0)
  {
    return;
  }
  TemporaryFiles & files = TemporaryFiles::GetInstance();
  // It is held to the end: nothing is made any more.
  const auto lock = files.Hold();
  files.RemoveAll();
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, received);
  std::signal(received, SIG_DFL);
  std::raise(received);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
}
} // namespace

void
WatchSignals()
{
  static bool isWatching = false;
  if (isWatching)
  {
    return;
  }
  isWatching = true;
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  const sigset_t signals = FindEndingSignals();
  sigset_t       before;
  pthread_sigmask(SIG_BLOCK, &signals, &before);
  try
  {
    std::thread(WaitForSignal, signals).detach();
  }
  catch (const std::system_error &)
  {
    // Without another thread the signals end the program at once.
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
}
} // namespace tissue
