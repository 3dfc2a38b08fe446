/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ImageDataFiles_h
#define ImageDataFiles_h

#include <string>
#include <vector>

namespace tissue
{
/** \brief The files with the voxels of an image whose header is a file of its own.
 *
 * Those that a header of MetaImage or NRRD names, also as a list or by a pattern of numbers, and the other one of a
 * pair of NIfTI or Analyze; the file alone of the data set "FILE:/NAME" of HDF5. None for other files, and for those
 * that cannot be read. */
std::vector<std::string>
FindImageDataFiles(const std::string & header);
} // namespace tissue

#endif
