#include "app/cli/back_end.h"

#include "core/error.h"
#include "render/splat/cpu_renderer.h"

namespace stipple {

struct BackEnd::Context {};

BackEnd::BackEnd(Backend backend) {
  if (backend == Backend::kGl) throw IoError("the back end 'gl' is not part of this program");
  renderer_ = std::make_unique<CpuRenderer>();
}

BackEnd::~BackEnd() = default;

}  // namespace stipple
