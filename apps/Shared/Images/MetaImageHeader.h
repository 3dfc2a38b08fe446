/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MetaImageHeader_h
#define MetaImageHeader_h

#include <string>

namespace tissue
{
/** Whether ITK would take a file of this extension and this beginning for a MetaImage, .mha or .mhd. */
bool
IsMetaImage(const std::string & path);

/** \brief Throws std::runtime_error where the header of a MetaImage is none that ITK's reader, MetaIO, survives.
 *
 * MetaIO writes texts into arrays of fixed length, goes on without end behind a value that is no number, and takes
 * names of files for formats of printf. Fields may come in any order, ElementDataFile last; 1 to 10 dimensions. The
 * voxels may be behind the header, in a file, in those of a LIST, or in those of a pattern, `slice%03d.raw 1 20 1`; see
 * FindVoxelFile() and RequireVoxels(). */
void
RequireSoundMetaImage(const std::string & path);
} // namespace tissue

#endif
