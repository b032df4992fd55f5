#include "render/splat/frame_targets.h"

namespace stipple {

FrameTargets::FrameTargets(int width, int height)
    : visible(gl::Format::kRgba32Ui, width, height),
      depth(gl::Format::kDepth32F, width, height),
      colorSum(gl::Format::kRgba16F, width, height),
      normalSum(gl::Format::kRgba16F, width, height),
      visibility({&visible}, &depth),
      sums({&colorSum, &normalSum}, &depth),
      mesh({&visible, &colorSum, &normalSum}, &depth) {}

PictureTargets::PictureTargets(int width, int height)
    : mean(gl::Format::kRgba32F, width, height),
      encoded(gl::Format::kRgba8, width, height),
      accumulation({&mean}),
      encoding({&encoded}) {}

}  // namespace stipple
