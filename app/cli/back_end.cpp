#include "app/cli/back_end.h"

#include "core/error.h"
#include "render/gl/egl_context.h"

namespace stipple {

struct BackEnd::Context {
  gl::EglContext egl;
};

BackEnd::BackEnd(Backend backend) {
  if (backend != Backend::kCpu) {
    try {
      context_ = std::make_unique<Context>();
    } catch (const IoError&) {
      if (backend == Backend::kGl) throw;
      backend = Backend::kCpu;
    }
  }
  renderer_ = makeRenderer(backend);
}

BackEnd::~BackEnd() = default;

}  // namespace stipple
