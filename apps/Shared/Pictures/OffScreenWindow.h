/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef OffScreenWindow_h
#define OffScreenWindow_h

#include <vtkSmartPointer.h>

#include <string>

class vtkRenderWindow;

namespace tissue
{
/** \brief OpenGL without a display, by EGL (platform surfaceless of Mesa), which VTK can draw with where its own
 * windows need X.
 *
 * Makes the context current, one for the whole run. Returns why that cannot be; empty where it can. */
std::string
FindSurfacelessObstacle();

/** A window that is not seen: on the display where there is one, else without.
 * \throws std::runtime_error where FindPictureObstacle() has something to say. */
vtkSmartPointer<vtkRenderWindow>
MakeOffScreenWindow();
} // namespace tissue

#endif
