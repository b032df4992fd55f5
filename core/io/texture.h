#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/points/attribute.h"

namespace stipple {

/// An image for texture coordinates: (0, 0) is its lower left corner, (1, 1) its upper right, repeated
/// beyond.
class Texture {
 public:
  /// Reads a PNG of any kind. Throws InvalidInput (not a PNG, corrupt, too large) or IoError.
  explicit Texture(const std::filesystem::path& path);

  /// Bilinear sample: red, green, blue from 0 to 255.
  Eigen::Vector3f sample(float u, float v) const;

 private:
  int width_ = 0, height_ = 0;
  std::vector<Rgba8> pixels_;  // rows from the top
};

}  // namespace stipple
