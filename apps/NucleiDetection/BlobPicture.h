/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef BlobPicture_h
#define BlobPicture_h

#include "Shared/Images/ScalarImageInput.h"
#include "Shared/Points/PointFileWriter.h"

namespace tissue
{
/** Writes a PNG of the image's brightest voxels along its last axis, above those along its second, with a circle of
 * its `radius` around each point. The longest axis has 800 pixels. Needs no display. \throws std::runtime_error where
 * it cannot be written. */
void
WriteBlobPicture(const ScalarImage * image, const PointTable & blobs, const std::string & path);
} // namespace tissue

#endif
