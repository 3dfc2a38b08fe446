/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PointBox_h
#define PointBox_h

#include "NucleiTessellation/NucleiTessellationOptions.h"
#include "Shared/Reconstruction/TissueInput.h"

#include <itkImageBase.h>

namespace tissue
{
/** The box that the points were seen in: that of another image, or of the one that they are from; null if there is
 * none. All channels and frames of a file fill the same box: none needs to be chosen.
 * \param input gets the unit of another image, and what is to be said of its file.
 * \throws FileError: no image of three dimensions. */
itk::ImageBase<3>::Pointer
FindBox(const CenterOptions & options, TissueInput & input);
} // namespace tissue

#endif
