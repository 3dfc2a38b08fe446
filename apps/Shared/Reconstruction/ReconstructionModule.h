/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ReconstructionModule_h
#define ReconstructionModule_h

#include "Shared/CommandLine/SlicerModuleDescription.h"
#include "Shared/Files/ReturnParameters.h"
#include "Shared/Reconstruction/ReconstructionReport.h"

namespace tissue
{
/** \brief What a program that makes meshes tells 3D Slicer.
 *
 * The presets are left out: Slicer always passes numbers, which a preset would not know. So is --strict, as Slicer does
 * not load what a program with an exit code has written.
 * \param uses of the options of the program alone. */
SlicerModule
MakeReconstructionModule(const std::string & title, const std::map<std::string, SlicerUse> & uses);

/** The results that the module has, in their order. */
ReturnParameters
CollectResults(const ReconstructionReport & report);
} // namespace tissue

#endif
