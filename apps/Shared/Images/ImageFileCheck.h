/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ImageFileCheck_h
#define ImageFileCheck_h

#include <itkImageIOBase.h>

#include <string>
#include <vector>

namespace tissue
{
/** \brief Throws std::runtime_error where the file is shorter than the voxels that its header promises.
 *
 * For the formats that ITK reads to a file's end and beyond without a word: NIfTI, GIPL, MRC and binary VTK, gzipped or
 * not. Does nothing for others. `io` has read the header of the file. */
void
RequireAllVoxels(const std::string & path, const itk::ImageIOBase * io);

/** \brief Judges what was written on standard error while an image was read, line by line.
 *
 * The libraries of MetaImage and TIFF tell so, and only so, of a file that is cut off or broken: throws
 * std::runtime_error with their words. All else is returned as warnings. */
std::vector<std::string>
JudgeMessages(const std::string & messages, const itk::ImageIOBase * io);
} // namespace tissue

#endif
