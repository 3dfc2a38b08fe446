/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef NiftiHeader_h
#define NiftiHeader_h

#include <string>

namespace tissue
{
/** \brief Throws std::runtime_error where a file of NIfTI, or of Analyze, has numbers that ITK's reader ends the
 * program at: places, directions or sizes of voxels that are no numbers.
 *
 * Judges files with the 348 bytes of a header of NIfTI 1 or Analyze, gzipped or not, of either order of bytes; the
 * header of the pair for the name of its voxels. Does nothing for others. */
void
RequireSoundNifti(const std::string & path);
} // namespace tissue

#endif
