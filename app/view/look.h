#pragma once

#include <string>

#include "render/appearance/splat_colors.h"

namespace stipple {

/// What of a point set is shown, and how.
struct Look {
  ColorSource colors = {};
  std::string marked =
      {};               ///< an attribute that is shown like a selection where it is not 0; empty: `selection`
  bool asMesh = false;  ///< its triangles instead of splats, where it has any
  std::string glyphs = {};  ///< a vector attribute that is shown as lines; empty: none
};

}  // namespace stipple
