/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OMELayout_h
#define OMELayout_h

#include "StackLayout.h"

namespace tissue
{
/** \brief The layout that OME-XML tells of the first image in it; nothing where the XML is no OME-XML with pixels.
 *
 * Takes the sizes, the order of the dimensions, the blocks of planes (TiffData) with their files (UUID), and the
 * physical sizes in any unit of length. Planes that no block names are of another file. Samples of a pixel are
 * channels; a page holds all of a channel's. Of several images a warning tells that the first is read. \param fileName
 * of the file itself: blocks of files of other names and UUIDs are not in it, unless all are of one. \throws
 * std::runtime_error: XML that is not well formed, sizes that are no numbers. */
std::optional<StackLayout>
ReadOMELayout(const std::string & xml, const std::string & fileName);
} // namespace tissue

#endif
