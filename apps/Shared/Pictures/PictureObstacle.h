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
/** Why VTK's own windows cannot be drawn in here, and what to do about it; empty where they can: without a display VTK
 * ends the program where it renders. */
std::string
FindDisplayObstacle();

/** Why WriteWallMeshPicture() cannot work here, neither on a display nor without; empty where it can. Takes little
 * time, so it is to be asked before the work. */
std::string
FindPictureObstacle();
} // namespace tissue

#endif
