/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SignalWatch_h
#define SignalWatch_h

namespace tissue
{
/** \brief Lets signals end the program without temporary files; see TemporaryFiles.
 *
 * SIGINT, SIGTERM, SIGHUP, SIGQUIT and SIGXCPU end it as ever, by the signal itself, within moments in any phase, once
 * its temporary files are removed; files that are given their names just then all get them. Those that are ignored stay
 * so. SIGXFSZ and SIGPIPE end it no more: to write fails instead, with the system's own reason. To be called before
 * there is another thread; does nothing the second time. */
void
WatchSignals();
} // namespace tissue

#endif
