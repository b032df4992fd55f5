#include "app/cli/back_end.h"

#include "app/cli/command.h"
#include "render/gl/egl_context.h"

namespace stipple {

struct BackEnd::Context {
  gl::EglContext egl;
};

BackEnd::BackEnd(Backend backend) {
  try {
    if (backend != Backend::kCpu) context_ = std::make_unique<Context>();
    renderer_ = makeRenderer(backend);
  } catch (const IoError& error) {
    if (backend == Backend::kGl) throw CommandFailure(kFailed, error.what());
    renderer_ = makeRenderer(Backend::kCpu);
  }
}

BackEnd::~BackEnd() = default;

}  // namespace stipple
