#include "render/gl/egl_context.h"

#include <epoxy/egl.h>

#include <array>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace stipple::gl {

namespace {

// Displays that need no window system: Mesa's without surfaces, then one for each graphics card, then the
// default.
std::vector<EGLDisplay> findDisplays() {
  std::vector<EGLDisplay> displays;
  const auto addPlatform = [&displays](EGLenum platform, void* native) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(platform, native, nullptr);
    if (display != EGL_NO_DISPLAY) displays.push_back(display);
  };
  const auto has = [](const char* extension) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension); };
  if (has("EGL_EXT_platform_base") && has("EGL_MESA_platform_surfaceless")) {
    addPlatform(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  }
  if (has("EGL_EXT_platform_base") && has("EGL_EXT_platform_device") && has("EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (eglQueryDevicesEXT(devices.size(), devices.data(), &count)) {
      for (EGLint i = 0; i < count; ++i) addPlatform(EGL_PLATFORM_DEVICE_EXT, devices[i]);
    }
  }
  if (const EGLDisplay standard = eglGetDisplay(EGL_DEFAULT_DISPLAY)) displays.push_back(standard);
  return displays;
}

// EGL_NO_CONTEXT where the display has no such context, or cannot do without a surface.
EGLContext createContext(EGLDisplay display) {
  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") || !eglBindAPI(EGL_OPENGL_API)) {
    return EGL_NO_CONTEXT;
  }
  constexpr std::array<EGLint, 5> kConfig = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                             EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (!eglChooseConfig(display, kConfig.data(), &config, 1, &found) || found == 0) return EGL_NO_CONTEXT;
  constexpr std::array<EGLint, 9> kVersion = {EGL_CONTEXT_MAJOR_VERSION,
                                              4,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              5,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_CONTEXT_OPENGL_DEBUG,
                                              EGL_TRUE,
                                              EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, kVersion.data());
}

}  // namespace

EglContext::EglContext() {
  if (!epoxy_has_egl()) throw IoError("OpenGL without a window is not to be had: there is no EGL library");
  for (const EGLDisplay display : findDisplays()) {
    EGLint major = 0, minor = 0;
    if (!eglInitialize(display, &major, &minor)) continue;
    const EGLContext handle = createContext(display);
    if (handle == EGL_NO_CONTEXT) continue;
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle)) {
      if (const auto context = currentContext(); context && context->version >= 45) {
        display_ = display;
        handle_ = handle;
        context_ = *context;
        return;
      }
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, handle);
  }
  throw IoError("OpenGL without a window is not to be had: no EGL display of this system offers OpenGL 4.5");
}

EglContext::~EglContext() {
  // The display stays initialized: another context of this process may use it.
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, handle_);
}

}  // namespace stipple::gl
