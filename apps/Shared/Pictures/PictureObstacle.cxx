/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/PictureObstacle.h"

#include "Shared/Pictures/OffScreenWindow.h"

#include <vtkRenderingOpenGLConfigure.h>

// A source of its own: the macros of X11 go badly with other headers.
#ifdef VTK_USE_X
#  include <X11/Xlib.h>

#  include <cstdlib>
#  include <memory>
#endif

namespace tissue
{
std::string
FindDisplayObstacle()
{
#ifdef VTK_USE_X
  const char * const name = std::getenv("DISPLAY");
  Display * const    display = XOpenDisplay(nullptr);
  if (!display)
  {
    return std::string("A picture needs an X display, and ") +
           (name ? "'" + std::string(name) + "' (DISPLAY) cannot be opened" : std::string("DISPLAY is not set")) +
           "; run the program under 'xvfb-run -a'";
  }
  // One connection is kept to the end: a server whose last client leaves resets itself, and refuses others meanwhile.
  static std::unique_ptr<Display, decltype(&XCloseDisplay)> kept(nullptr, XCloseDisplay);
  kept.reset(display);
  int ignored = 0;
  if (!XQueryExtension(display, "GLX", &ignored, &ignored, &ignored))
  {
    return "A picture needs OpenGL, which the X display '" + std::string(name) +
           "' lacks (GLX); run the program under 'xvfb-run -a'";
  }
#endif
  return "";
}

std::string
FindPictureObstacle()
{
  const std::string ofDisplay = FindDisplayObstacle();
  const std::string without = ofDisplay.empty() ? "" : FindSurfacelessObstacle();
  return without.empty() ? "" : ofDisplay + " (it would need none, but " + without + ")";
}
} // namespace tissue
