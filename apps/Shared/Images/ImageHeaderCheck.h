/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef ImageHeaderCheck_h
#define ImageHeaderCheck_h

#include <itkImageIOBase.h>

#include <string>

namespace tissue
{
/** \brief Throws std::runtime_error where a file is none that ITK's readers may be asked about.
 *
 * It must be a regular file, and the header of MetaImage, NRRD or NIfTI must keep to its format: see
 * RequireSoundMetaImage(), RequireSoundNrrd() and RequireSoundNifti(). */
void
RequireSoundHeader(const std::string & path);

/** \brief Throws std::runtime_error where a header that has been read promises what cannot be.
 *
 * An axis of no voxel, more bytes than the file, and those it names, can hold compressed; a voxel whose size is not in
 * 1e-12 .. 1e12, which the user's own may replace, an origin beyond 1e12 or 1e9 voxels, or directions that are no unit
 * vectors by far. */
void
RequireSoundGeometry(const std::string & path, const itk::ImageIOBase * io, bool hasOwnSpacing);
} // namespace tissue

#endif
