/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SlicerOptions_h
#define SlicerOptions_h

#include "Shared/CommandLine/SlicerModuleDescription.h"

namespace tissue
{
/** Adds what 3D Slicer asks of its modules, in a group of their own: --xml, which prints the description and ends the
 * program, whatever is required of it, --logo, which there is none of, --echo, which prints all options with their
 * values, and --processinformationaddress, which is of no use to a program of its own.
 * \param module is copied.
 * \param returnParameterFile of --returnparameterfile, for the results; must outlive the parsing. */
void
AddSlicerOptions(CLI::App & app, const SlicerModule & module, std::string & returnParameterFile);
} // namespace tissue

#endif
