/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef NrrdHeader_h
#define NrrdHeader_h

#include <string>

namespace tissue
{
/** Whether the file begins as one of NRRD. */
bool
IsNrrd(const std::string & path);

/** \brief Throws std::runtime_error where the header of an NRRD file promises what is not there, or cannot be.
 *
 * 1 to 16 dimensions, as many sizes above 0; voxels behind the header, in a file, in those of a LIST or in those of a
 * pattern, `data file: slice%03d.raw 1 20 1`; see FindVoxelFile() and RequireVoxels(). All else is left to ITK's
 * reader.
 */
void
RequireSoundNrrd(const std::string & path);
} // namespace tissue

#endif
