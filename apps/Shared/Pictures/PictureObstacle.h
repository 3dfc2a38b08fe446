/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef PictureObstacle_h
#define PictureObstacle_h

#include <string>

namespace tissue
{
/** Why WriteWallMeshPicture() cannot work here, and what to do about it; empty where it can. Costs nothing, so it is to
 * be asked before the work: without a display VTK ends the program where it renders. */
std::string
FindPictureObstacle();
} // namespace tissue

#endif
