#pragma once

#include <span>

namespace stipple {

/// OpenType files of the typeface Inter, of resources/fonts.
std::span<const unsigned char> interRegular();
std::span<const unsigned char> interSemiBold();

}  // namespace stipple
