/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Pictures/OffScreenWindow.h"

#include "Shared/Pictures/PictureObstacle.h"

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <cstring>
#include <iostream>
#include <stdexcept>

#ifdef TISSUE_TESSELLATION_HAS_EGL
// Its types of X, whose macros go badly with other headers, are not needed.
#  define EGL_NO_X11
#  include <EGL/egl.h>
#  include <EGL/eglext.h>
#endif

namespace tissue
{
namespace
{
#ifdef TISSUE_TESSELLATION_HAS_EGL
/** The least that VTK draws with is OpenGL 3.2. */
std::string
MakeSurfacelessContext()
{
  const auto getDisplay =
    reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const char * const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (getDisplay == nullptr || extensions == nullptr ||
      std::strstr(extensions, "EGL_MESA_platform_surfaceless") == nullptr)
  {
    return "EGL has no platform without surfaces";
  }
  EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
      eglBindAPI(EGL_OPENGL_API) == EGL_FALSE)
  {
    return "EGL has no OpenGL";
  }
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
  const EGLint version[] = {
    EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE
  };
  EGLConfig config = nullptr;
  EGLint    number = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &number) == EGL_FALSE || number == 0)
  {
    return "EGL has no configuration for OpenGL";
  }
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  const bool isCurrent =
    context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE;
  return isCurrent ? "" : "EGL has no OpenGL 3.2";
}
#endif

/** VTK has the functions of OpenGL by GLEW, which it tells as an error that there is no display, and has them all the
 * same. */
void
PassErrorOn(vtkObject *, unsigned long, void *, void * message)
{
  const char * const text = static_cast<const char *>(message);
  if (std::strstr(text, "GLEW could not be initialized") == nullptr)
  {
    std::cerr << text;
  }
}
} // namespace

std::string
FindSurfacelessObstacle()
{
#ifdef TISSUE_TESSELLATION_HAS_EGL
  static const std::string obstacle = MakeSurfacelessContext();
  return obstacle;
#else
  return "EGL was not there when this program was built";
#endif
}

vtkSmartPointer<vtkRenderWindow>
MakeOffScreenWindow()
{
  const std::string obstacle = FindPictureObstacle();
  if (!obstacle.empty())
  {
    throw std::runtime_error(obstacle);
  }
  if (FindDisplayObstacle().empty())
  {
    const auto window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetOffScreenRendering(1);
    return window;
  }
  const auto                       window = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  const vtkNew<vtkCallbackCommand> errors;
  errors->SetCallback(PassErrorOn);
  window->AddObserver(vtkCommand::ErrorEvent, errors);
  window->SetOwnContext(0);
  window->SetIsCurrent(true);
  window->SetOffScreenRendering(1);
  return window;
}
} // namespace tissue
