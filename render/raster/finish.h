#pragma once

#include <optional>
#include <vector>

#include "render/appearance/appearance.h"
#include "render/appearance/image.h"
#include "render/hierarchy/view.h"
#include "render/raster/frame.h"

namespace stipple {

/// Pixels [x0, x1) x [y0, y1).
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// Eye-dome lighting (Boucheny 2009) and the ring of the brush, on the light of a frame. Needs the depth of
/// two pixels around what it works on.
class Finisher {
 public:
  /// Takes the depths of the whole frame in.
  void takeDepth(const FrameBuffers& frame, const View& view, const Progress* progress);
  void finish(FrameBuffers& frame, const View& view, const Appearance& appearance,
              const PixelRect& rect) const;

  /// Pixels that neighbors look at.
  static constexpr int kReach = 2;

 private:
  void finishRow(FrameBuffers& frame, const Appearance& appearance, int y, const PixelRect& rect) const;

  int stride_ = 0;
  std::vector<float> depth_;  // log2 of it (perspective) or in pictures' heights, with a rim of empty pixels
  float strength_ = 0;
};

/// The picture over its background: linear light to sRGB.
Image encode(const FrameBuffers& frame, const std::optional<Rgba8>& background);

}  // namespace stipple
