#include "render/splat/renderer.h"

#include <fmt/format.h>

#include "core/error.h"
#include "render/gl/context.h"
#include "render/splat/cpu_renderer.h"
#include "render/splat/gl_renderer.h"

namespace stipple {

namespace {

constexpr int kNeededVersion = 45;

// Why the current context does not do; empty where it does.
std::string lackOf(const std::optional<gl::Context>& context) {
  if (!context) return "OpenGL was asked for, and no OpenGL context is current";
  if (context->version >= kNeededVersion) return {};
  return fmt::format("OpenGL 4.5 was asked for, and {} offers {}.{}", context->renderer,
                     context->version / 10, context->version % 10);
}

}  // namespace

std::unique_ptr<Renderer> makeRenderer(Backend backend) {
  if (backend == Backend::kCpu) return std::make_unique<CpuRenderer>();
  const std::optional<gl::Context> context = gl::currentContext();
  const std::string lack = lackOf(context);
  if (backend == Backend::kGl) {
    if (!lack.empty()) throw IoError(lack);
    return std::make_unique<GlRenderer>();
  }
  // Where OpenGL is drawn by the processor, our own rasterizer is several times faster.
  if (!lack.empty() || context->isSoftware()) return std::make_unique<CpuRenderer>();
  return std::make_unique<GlRenderer>();
}

}  // namespace stipple
