/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SyntheticTestTissue_h
#define SyntheticTestTissue_h

#include "itkImage.h"

/** A dome of 40 anisotropic cells, labels 1 to 40 in exterior 0, of voxels of 0.5 x 0.5 x 1; of the types of pixels
 * that SyntheticTestTissue.cxx lists. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeSyntheticTestTissue();

#endif
