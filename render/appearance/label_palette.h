#pragma once

#include <span>

#include "core/points/attribute.h"

namespace stipple {

/// 256 colors, each as far from gray and from all before it as it can be: any first few are told apart best.
/// Greedy choice as in Glasbey et al. (2007), distances in Oklab (Ottosson 2020).
std::span<const Rgba8> labelPalette();

}  // namespace stipple
