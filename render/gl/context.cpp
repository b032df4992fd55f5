#include "render/gl/context.h"

#include <dlfcn.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace stipple::gl {

namespace {

// Asks a window-system library, if the process has it loaded; otherwise none of its contexts can be current.
bool hasCurrent(const char* library, const char* query) {
  void* loaded = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  if (!loaded) return false;
  const auto current = reinterpret_cast<void* (*)()>(dlsym(loaded, query));
  const bool has = current && current();
  dlclose(loaded);
  return has;
}

}  // namespace

bool Context::isSoftware() const {
  constexpr std::array<std::string_view, 4> kSoftware = {"llvmpipe", "softpipe", "swrast",
                                                         "Software Rasterizer"};
  return std::ranges::any_of(
      kSoftware, [this](std::string_view name) { return renderer.find(name) != std::string::npos; });
}

std::optional<Context> currentContext() {
  // The loader ends the program where it is called without a context.
  if (!hasCurrent("libEGL.so.1", "eglGetCurrentContext") &&
      !hasCurrent("libGLX.so.0", "glXGetCurrentContext") &&
      !hasCurrent("libGL.so.1", "glXGetCurrentContext")) {
    return std::nullopt;
  }
  if (!epoxy_is_desktop_gl()) return std::nullopt;
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return Context{.version = epoxy_gl_version(), .renderer = renderer ? renderer : ""};
}

}  // namespace stipple::gl
